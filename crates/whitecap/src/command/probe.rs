//! `whitecap probe`: the surface as numbers, from the model that moves it.

use super::options::{MAX_SEED, Place, parse_place_m, parse_time_s, parse_uv};
use crate::failure::Failure;
use crate::stdout;
use anyhow::anyhow;
use clap::ValueHint;
use glam::{DVec2, DVec3};
use std::fmt::Write as _;
use std::io::Write as _;
use std::process::ExitCode;
use whitecap_scene::sea::SeaSurface;
use whitecap_scene::{Scene, SceneSurface, named, technique};
use whitecap_waves::model::Surface;
use whitecap_waves::query::rest_under;

const EXAMPLES: &str = "\
Examples:
  whitecap probe --at 0,0                               the default scene, at its origin
  whitecap probe storm.toml --at -3,4 --at 10,4         two places of your own scene
  whitecap probe --at 0,0 --time 12.5 --json            another moment, for programs
  whitecap probe ocean-water --uv 0.3,0.7 --time 1      in the text's own units

The numbers are those of the sea that moves the technique's surface, in 64 bits and without a graphics \
adapter: the height over a place is the one that a floating object there has, calmed towards a shore where the \
technique calms it. x is east, y up, z south. Ripples that are only drawn, as by a normal map, do not count. --uv answers in the units and axes of the text, \
z up.";

/// Print height and normal of a scene's surface at given places
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Probe {
    /// A named scene, or the path of a scene file
    #[arg(default_value = named::DEFAULT, value_hint = ValueHint::FilePath)]
    scene: String,

    /// A place, in metres east and south of the origin, each from -10000000 to 10000000; may be repeated
    #[arg(long, value_name = "X,Z", allow_hyphen_values = true, required_unless_present = "uv",
        value_parser = parse_place_m)]
    at: Vec<Place>,

    /// A place in texture coordinates, for seas of sines; may be repeated, and is answered after each --at
    #[arg(long, value_name = "U,V", allow_hyphen_values = true, value_parser = parse_uv)]
    uv: Vec<Place>,

    /// The moment, in seconds from the scene's start: from -1000000 to 1000000
    #[arg(long, value_name = "SECONDS", default_value = "0", allow_hyphen_values = true,
        value_parser = parse_time_s)]
    time: f64,

    /// The seed of the sea's random phases, in place of the scene's
    #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u64).range(..=MAX_SEED))]
    seed: Option<u64>,

    /// Print a JSON list with x_m, z_m, time_s, height_m, displacement_m and normal of each place; for --uv
    /// with u, v, time_s, height and normal
    #[arg(long)]
    pub(crate) json: bool,
}

impl Probe {
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let mut scene = whitecap_scene::open(&self.scene)?;
        scene.seed = self.seed.unwrap_or(scene.seed);
        let surface = scene.surface()?;
        let in_world: Vec<InWorld> =
            self.at.iter().map(|&place| in_world(&surface, place, self.time)).collect();
        let in_text = self.in_text(&scene, surface.sea())?;
        if let SeaSurface::Calm(_) = surface.sea() {
            // Nobody is left to tell if standard error is closed.
            let _ = writeln!(
                std::io::stderr(),
                "note: the technique {} does not move its surface, which is level everywhere",
                scene.technique.word()
            );
        }
        if self.json {
            let worlds = in_world.into_iter().map(Answer::InWorld);
            stdout::write_json(&worlds.chain(in_text.into_iter().map(Answer::InText)).collect::<Vec<_>>())?;
        } else {
            stdout::write(for_people(&in_world, &in_text).as_bytes())?;
        }
        Ok(ExitCode::SUCCESS)
    }

    fn in_text(&self, scene: &Scene, sea: &SeaSurface) -> Result<Vec<InText>, Failure> {
        match sea {
            SeaSurface::Sines(sines) => {
                let answer = |&[u, v]: &Place| {
                    let surface = sines.at_uv(DVec2::new(u, v), self.time, 0.0);
                    InText {
                        u,
                        v,
                        time_s: self.time,
                        height: surface.height + 0.0,
                        normal: array(surface.normal),
                    }
                };
                Ok(self.uv.iter().map(answer).collect())
            }
            _ if self.uv.is_empty() => Ok(Vec::new()),
            _ => {
                let having: Vec<&str> = technique::that_draw("sines").collect();
                Err(Failure::Input(anyhow!(
                    "{}: the technique {} has no texture coordinates to ask by; --uv is for {}",
                    self.scene,
                    scene.technique.word(),
                    having.join(" and ")
                )))
            }
        }
    }
}

/// The surface over one place.
#[derive(serde::Serialize)]
#[serde(untagged)]
enum Answer {
    InWorld(InWorld),
    InText(InText),
}

/// In metres: x east, y up, z south.
#[derive(serde::Serialize)]
struct InWorld {
    x_m: f64,
    z_m: f64,
    time_s: f64,
    height_m: f64,
    /// Of the water that is over the place, from where it rests.
    displacement_m: [f64; 3],
    normal: [f64; 3],
}

/// In the units of the text: x along u, y along v, z up.
#[derive(serde::Serialize)]
struct InText {
    u: f64,
    v: f64,
    time_s: f64,
    height: f64,
    normal: [f64; 3],
}

fn in_world(surface: &SceneSurface, [x_m, z_m]: Place, time_s: f64) -> InWorld {
    let point = surface.sample(rest_under(surface, DVec2::new(x_m, z_m), time_s), time_s);
    let displacement_m = array(point.displacement_m);
    InWorld { x_m, z_m, time_s, height_m: displacement_m[1], displacement_m, normal: array(point.normal) }
}

/// A negative zero becomes a plain one: it is the same place, and reads better.
fn array(vector: DVec3) -> [f64; 3] {
    vector.to_array().map(|component| component + 0.0)
}

fn for_people(in_world: &[InWorld], in_text: &[InText]) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    if !in_world.is_empty() {
        let _ = writeln!(
            text,
            "{:>12} {:>12} {:>10} {:>10}  {:^32}  {:^29}",
            "x, m", "z, m", "time, s", "height, m", "displacement, m", "normal"
        );
    }
    for InWorld { x_m, z_m, time_s, height_m, displacement_m: [dx, dy, dz], normal: [nx, ny, nz] } in in_world
    {
        let _ = writeln!(
            text,
            "{x_m:12} {z_m:12} {time_s:10} {height_m:10.4}  {dx:10.4} {dy:10.4} {dz:10.4}  \
             {nx:9.5} {ny:9.5} {nz:9.5}"
        );
    }
    if !in_text.is_empty() {
        let _ =
            writeln!(text, "{:>12} {:>12} {:>10} {:>12}  {:^32}", "u", "v", "time, s", "height", "normal");
    }
    for InText { u, v, time_s, height, normal: [nx, ny, nz] } in in_text {
        let _ = writeln!(text, "{u:12} {v:12} {time_s:10} {height:12.5}  {nx:10.6} {ny:10.6} {nz:10.6}");
    }
    text
}

//! A whole scene: read from TOML, checked, written back.

use std::io::Read;
use std::path::Path;
use std::sync::Arc;

use serde::ser::{Serialize, SerializeMap, Serializer};
use toml::de::DeTable;

use crate::camera::Camera;
use crate::error::SceneError;
use crate::key::{Key, Seed, Tables, or};
use crate::named;
use crate::object::{self, Model, Object};
use crate::panorama::Panorama;
use crate::picture::Picture;
use crate::reader::{Source, TableReader, did_you_mean, quoted_list};
use crate::sea::Sea;
use crate::sky::Sky;
use crate::technique::{self, Technique};

/// The largest scene file, bytes: a thousand times what a scene needs.
const MAX_BYTES: u64 = 1 << 20;

/// What a scene file says, checked: every number is in its range, and the sea can be built.
///
/// It serialises in the shape of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// How the water is drawn.
    pub technique: Technique,
    /// Where everything random begins. Equal scenes with equal seeds look alike on every machine.
    pub seed: u64,
    /// The sea.
    pub sea: Sea,
    /// The sky.
    pub sky: Sky,
    /// Where the scene is seen from.
    pub camera: Camera,
    /// How light becomes a picture.
    pub picture: Picture,
    /// What stands or floats in the water.
    pub objects: Vec<Object>,
    /// The picture of a sky that is one, if the scene came from a file. It is not part of what the file says.
    pub panorama: Option<Arc<Panorama>>,
    /// The objects with their meshes, if there are any and the scene came from a file. They are not part of what the file says.
    pub models: Option<Vec<Model>>,
    /// Where its sea bends what the file asks for, where the picture of its sky is no light and where its camera is in the
    /// way of what it looks at, one sentence each, as far as all that was built when it was read. They are not part of what the file
    /// says.
    pub warnings: Vec<String>,
}

/// Reads the scene that `name_or_path` says: a named scene, or else a file.
///
/// # Errors
///
/// If there is no such scene and no such file, or what is there cannot be used.
pub fn open(name_or_path: &str) -> Result<Scene, SceneError> {
    let path = Path::new(name_or_path);
    let looks_like_name = path.extension().is_none() && path.components().count() <= 1;
    if named::find(name_or_path).is_some() || (looks_like_name && !path.exists()) {
        return of_name(name_or_path, ", or the path of a scene file");
    }
    Scene::load(path)
}

/// Reads the scene of this name. Nothing that is said here leads to a file.
///
/// # Errors
///
/// If there is no such scene.
pub fn open_named(name: &str) -> Result<Scene, SceneError> {
    of_name(name, "")
}

fn of_name(name: &str, or_else: &str) -> Result<Scene, SceneError> {
    if let Some(named) = named::find(name) {
        return Scene::from_toml(named.toml, &format!("{}.toml", named.name));
    }
    let names: Vec<_> = named::ALL.iter().map(|scene| scene.name).collect();
    let (meant, accepted) = (did_you_mean(name, &names), quoted_list(&names));
    Err(SceneError::about_file(name, format!("no such scene; {meant}accepted: {accepted}{or_else}")))
}

impl Scene {
    /// Reads a scene file and the picture of its sky, if it has one, and checks that its sea can be built. Files that it names are relative to its
    /// folder; the scene holds their whole paths.
    ///
    /// # Errors
    ///
    /// If the file cannot be read, is longer than 1 MiB, or says something that is not accepted, or if the
    /// picture of its sky cannot be read.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let origin = path.display().to_string();
        let text = text_of(path).map_err(|problem| SceneError::about_file(&origin, problem))?;
        Self::read_text(&text, &origin, |scene| {
            let objects = scene.objects.iter_mut().filter_map(|object| object.file.as_mut());
            for file in scene.sky.file_mut().into_iter().chain(objects).chain(scene.sea.files_mut()) {
                if let Ok(path) = std::path::absolute(path)
                    && let Some(folder) = path.parent()
                {
                    *file = folder.join(&file);
                }
            }
            scene.build_once()?;
            if let Sky::Panorama(sky) = &scene.sky {
                let picture =
                    sky.load().map_err(|error| SceneError::about_key("sky.file", error.to_string()))?;
                if picture.repaired > 0 {
                    scene.warnings.push(format!(
                        "sky.file: {} of {} pixels are negative, not finite or brighter than 65504; they count as 0 or as \
                         65504",
                        picture.repaired,
                        picture.pixels.len()
                    ));
                }
                scene.panorama = Some(Arc::new(picture));
            }
            if !scene.objects.is_empty() {
                scene.models = Some(scene.read_objects()?);
            }
            scene.look_round();
            Ok(())
        })
    }

    /// Reads the text of a scene file; `origin` is what errors call it. Paths stay as they are written.
    ///
    /// # Errors
    ///
    /// If the text is not TOML, longer than 1 MiB, or says something that is not accepted.
    pub fn from_toml(text: &str, origin: &str) -> Result<Self, SceneError> {
        Self::read_text(text, origin, |scene| {
            // What its files hold is for `load` to say, which knows where they are.
            if scene.sea.files_mut().next().is_none() {
                scene.build_once()?;
            }
            scene.look_round();
            Ok(())
        })
    }

    /// Reads and checks `text`, and lets `finish` add what the text alone does not hold.
    fn read_text(
        text: &str,
        origin: &str,
        finish: impl FnOnce(&mut Self) -> Result<(), SceneError>,
    ) -> Result<Self, SceneError> {
        if text.len() as u64 > MAX_BYTES {
            return Err(SceneError::about_file(origin, TOO_LONG));
        }
        let source = Source { origin, text };
        let root = DeTable::parse(text).map_err(|error| source.syntax_error(&error))?;
        let table = TableReader::root(&source, root.get_ref());
        let mut scene = Self::read(&table)?;
        finish(&mut scene).map_err(|error| table.locate(error))?;
        Ok(scene)
    }

    /// The scene as the text of a scene file, without comments. Reading it gives an equal scene.
    ///
    /// # Errors
    ///
    /// If the scene was changed to something that a scene file cannot say, such as a number out of its range.
    pub fn to_toml(&self) -> Result<String, SceneError> {
        let text =
            toml::to_string(self).map_err(|error| SceneError::about_file("the scene", error.to_string()))?;
        Self::from_toml(&text, "the scene")?;
        Ok(text)
    }

    fn read(table: &TableReader<'_>) -> Result<Self, SceneError> {
        table.only(Self::keys().iter().map(|key| key.key).chain(Self::tables()))?;
        let technique = Technique::read(table)?;
        let sea_table = table.table("sea")?;
        let mut sea = Sea::read(&sea_table, &technique)?;
        let (seed, sky) = (table.read("seed", &SEED)?, Sky::read(&table.table("sky")?)?);
        let camera = Camera::read_checked(&table.table("camera")?)?;
        sea.tiling = sea.tiling.seen_from(camera.position_m[1]);
        Ok(Self {
            seed,
            sky,
            camera,
            picture: Picture::read_for(table, &technique)?,
            objects: table.read("object", &OBJECTS)?,
            technique,
            sea,
            panorama: None,
            models: None,
            warnings: Vec::new(),
        })
    }

    /// Sees whether the sea can be built, and what it bends.
    fn build_once(&mut self) -> Result<(), SceneError> {
        self.warnings = self.sea.warnings(self.seed)?;
        Ok(())
    }

    /// Sees whether the camera stands where one can see something: over the water, and over the models if they were read.
    fn look_round(&mut self) {
        let ground = self.models.as_deref().and_then(object::ground);
        self.warnings.extend(self.camera.warning(self.sea.depth_m(), ground.as_ref()));
    }

    /// The objects with their meshes: those that were read with the file, or read now.
    ///
    /// # Errors
    ///
    /// If a mesh's file cannot be read.
    pub fn read_objects(&self) -> Result<Vec<Model>, SceneError> {
        match &self.models {
            Some(models) => Ok(models.clone()),
            None => {
                self.objects.iter().enumerate().map(|(index, object)| self.model(index, object)).collect()
            }
        }
    }

    fn model(&self, index: usize, object: &Object) -> Result<Model, SceneError> {
        object
            .model(self.seed)
            .map_err(|error| SceneError::about_key(format!("object[{index}].file"), error.to_string()))
    }

    /// The keys at the top of the file.
    pub(crate) fn keys() -> Vec<Key> {
        vec![technique::TAG.key(), Key::new("seed", "Where everything random begins.", &SEED)]
    }

    /// The tables at the top of the file.
    fn tables() -> impl Iterator<Item = &'static str> {
        ["sea", "sky", "camera", Picture::TABLE, "object"]
            .into_iter()
            .chain(technique::ALL.iter().map(|technique| technique.word))
    }
}

const SEED: crate::key::Or<Seed> = or(Seed, 0);

const OBJECTS: crate::key::Or<Tables<Object>> = or(object::OBJECTS, Vec::new());

const TOO_LONG: &str = "longer than a scene file may be; accepted: up to 1 MiB";

/// The text of a file, or what stands against it.
fn text_of(path: &Path) -> Result<String, String> {
    let cannot = |error: std::io::Error| format!("cannot be read: {error}");
    let file = std::fs::File::open(path).map_err(cannot)?;
    if file.metadata().map_err(cannot)?.is_dir() {
        return Err("this is a folder; accepted: a scene file".to_owned());
    }
    let mut bytes = Vec::new();
    file.take(MAX_BYTES + 1).read_to_end(&mut bytes).map_err(cannot)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(TOO_LONG.to_owned());
    }
    String::from_utf8(bytes).map_err(|error| {
        let line = 1 + error.as_bytes()[..error.utf8_error().valid_up_to()]
            .iter()
            .filter(|&&byte| byte == b'\n')
            .count();
        format!("line {line} is not UTF-8 text; accepted: TOML, saved as UTF-8")
    })
}

impl Serialize for Scene {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut scene = serializer.serialize_map(None)?;
        scene.serialize_entry("technique", self.technique.word())?;
        scene.serialize_entry("seed", &self.seed)?;
        scene.serialize_entry("sea", &self.sea)?;
        scene.serialize_entry(self.technique.word(), &self.technique)?;
        scene.serialize_entry("sky", &self.sky)?;
        scene.serialize_entry("camera", &self.camera)?;
        if self.technique.is_scene_linear() {
            scene.serialize_entry(Picture::TABLE, &self.picture)?;
        }
        if !self.objects.is_empty() {
            scene.serialize_entry("object", &self.objects)?;
        }
        scene.end()
    }
}

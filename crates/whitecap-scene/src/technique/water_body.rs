//! What the water does to the light in it: keys that techniques share.

use whitecap_waves::optics::water_body::PURE_ABSORPTION_PER_M as PURE;

use crate::error::SceneError;
use crate::key::Colour;
use crate::reader::TableReader;

/// A coefficient by colour.
pub(super) const PER_METRE: Colour = Colour { unit: "1/m", min: 1e-4, max: 10.0 };

/// The clearest sea at 650, 550 and 450 nm: pure sea water scatters, 0.00758 (400 nm/λ)^4.32 per m, …
pub(super) const CLEAREST_SCATTERING_PER_M: [f64; 3] = [0.000_93, 0.001_91, 0.004_56];

/// … and pure water absorbs (Pope & Fry 1997); extinction is the sum of the two.
pub(super) const CLEAREST_EXTINCTION_PER_M: [f64; 3] = [0.341, 0.058_4, 0.013_8];

/// What pure water absorbs at 650, 550 and 450 nm (Pope & Fry 1997).
pub(super) const PURE_ABSORPTION_PER_M: [f64; 3] = [PURE[10], PURE[6], PURE[2]];

/// Refuses water that scatters more light than it takes out of a ray.
pub(super) fn check(
    table: &TableReader<'_>,
    scattering_per_m: [f64; 3],
    extinction_per_m: [f64; 3],
) -> Result<(), SceneError> {
    let mut channels = scattering_per_m.iter().zip(&extinction_per_m);
    if channels.any(|(scattering, extinction)| scattering > extinction) {
        return Err(table.error(
            Some("extinction_per_m"),
            format!(
                "less than scattering_per_m = {scattering_per_m:?}; accepted: extinction is scattering plus absorption"
            ),
        ));
    }
    Ok(())
}

//! What it took to be sure of each pixel.

use super::{of_each_pixel, size};
use crate::record::{Certificate, Counter, Entry, Recorder, What};
use crate::scene::Scene;
use crate::shape::Method;
use crate::trace::{Progress, trace_pixel};
use crate::view::{HeatMap, HeatScale};

/// The least sure certificate that any solver gave to any ray of each pixel; none if it was cancelled.
///
/// Pixels are recorded for this: each object that a ray may meet is asked for all of its hits, also for those behind the
/// closest one.
#[must_use]
pub fn tier_map(scene: &Scene, progress: &Progress) -> Option<HeatMap> {
    let values = of_each_pixel(scene.image, progress, |[x, y]| {
        let mut listener = Worst::default();
        let _ = trace_pixel(scene, x, y, &mut listener);
        match listener.worst {
            None | Some(Certificate::Certain) => 0.0,
            Some(Certificate::Fallback) => 1.0,
            Some(Certificate::Undecidable) => 2.0,
        }
    })?;
    // Only one method has something to fall back on.
    let doubtful = match scene.solving.method {
        Method::Adaptive => Certificate::Fallback.name(),
        _ => "unsure, with nothing to fall back on",
    };
    let classes = [Certificate::Certain.name(), doubtful, Certificate::Undecidable.name()];
    Some(HeatMap {
        title: "What it took to be sure".to_owned(),
        notes: vec!["The least sure answer that any solver gave to any ray of the pixel.".to_owned()],
        size: size(scene.image),
        scale: HeatScale::Classes(classes.map(str::to_owned).to_vec()),
        values,
        ..HeatMap::default()
    })
}

/// Listens for certificates, and to nothing else.
#[derive(Default)]
struct Worst {
    worst: Option<Certificate>,
}

impl Recorder for Worst {
    const RECORDING: bool = true;

    fn begin(&mut self) {}

    fn end(&mut self, describe: impl FnOnce() -> Entry) {
        // Nothing is worse than this.
        if self.worst == Some(Certificate::Undecidable) {
            return;
        }
        if let What::Decision { certificate, .. } = describe().what {
            self.worst = self.worst.max(Some(certificate));
        }
    }

    fn count(&mut self, _counter: Counter) {}
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::load;

    /// The one pixel of a picture whose ray goes down beside the z axis at the distance x, past a unit sphere.
    fn tiers(x: f64) -> Vec<f64> {
        let text = format!(
            r#"{{ "image": {{ "width": 1, "height": 1 }},
                 "camera": {{ "eye": [{x}, 0, 8], "look_at": [{x}, 0, 0], "up": [0, 1, 0], "field_of_view": 30 }},
                 "materials": {{ "clay": {{ "diffuse": [1, 1, 1] }} }},
                 "objects": [ {{ "shape": "sphere", "name": "ball", "material": "clay" }} ] }}"#
        );
        let scene = load(&text, "tier").unwrap();
        tier_map(&scene, &Progress::new()).unwrap().values
    }

    #[test]
    fn a_ray_that_goes_in_deep_is_certain_and_one_that_touches_is_undecidable() {
        assert_eq!(tiers(0.25), [0.0]);
        assert_eq!(tiers(1.0), [2.0]);
    }
}

//! Things made up for tests: what cameras, wavelengths and media add to a ray, with numbers that a person can check.

use super::sample::Sketch;
use crate::record::{
    Average, Conductor, Confusion, Lens, LightSample, Overlap, Passage, Phase, Sample, Scatter, Segment, Wavelength,
    What,
};

/// The second sample of a pixel, half a pixel to the right of its centre.
pub fn second_sample() -> What {
    What::Sample(Sample { number: 1, at: [33.0, 24.5], offset: [0.5, 0.0], weight: 1.0 })
}

/// Two samples together.
pub fn average() -> What {
    What::Average(Average {
        samples: 2,
        filter: "box".into(),
        weights: 2.0,
        error: Some(0.25),
        stopped: "the scene asks for 2 samples".into(),
        colour: [0.25, 0.5, 0.75],
    })
}

/// A lens of radius 0.5 that looks down from (0, 0, 4), sharp at a distance of 2, and a hit half a unit beyond.
pub fn lens() -> What {
    What::Lens(Lens {
        aperture: "polygon".into(),
        outline: vec![[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]],
        radius: 0.5,
        focus_distance: 2.0,
        at: [0.5, 0.0],
        eye: [0.0, 0.0, 4.0],
        forward: [0.0, 0.0, -1.0],
        point: [0.25, 0.0, 4.0],
        focus: [0.0, 0.0, 2.0],
    })
}

/// 2 · 0.5 · |2.5 − 2| / (2.5 · 2) = 0.1.
pub fn confusion() -> What {
    What::Confusion(Confusion { depth: 2.5, diameter: 0.1, pixels: 4.8 })
}

/// A point of a disc straight above.
pub fn light_sample() -> What {
    What::LightSample(LightSample {
        shape: "disc".into(),
        number: 0,
        of: 4,
        at: [0.5, 0.25],
        point: [0.0, 0.0, 4.5],
        towards: [0.0, 0.0, 1.0],
        distance: 5.0,
        arriving: [0.25; 3],
        diffuse: [0.05; 3],
        specular: [0.0; 3],
    })
}

/// A stretch of length 1 in mist.
pub fn segment() -> Segment {
    Segment {
        medium: "mist".into(),
        from: [0.0, 0.0, -0.5],
        to: Some([0.0, 0.0, -1.5]),
        length: 1.0,
        absorption: [0.25; 3],
        scattering: [0.5; 3],
        transmittance: [0.472_366_552_741_014_7; 3],
    }
}

/// Light from a lamp at an angle of 37° to the ray, in mist that turns light every way alike.
pub fn phase() -> Phase {
    Phase {
        towards: "lamp".into(),
        anisotropy: 0.0,
        cosine: 0.8,
        value: 0.079_577_471_545_947_67,
        direction: [0.0, 0.6, 0.8],
    }
}

/// A wavelength, a metal, a medium with a point in it, and two objects that overlap.
pub fn light_on_its_way(sketch: &mut Sketch) {
    sketch.note(What::Wavelength(Wavelength {
        number: 0,
        of: 2,
        nanometres: 475.0,
        band: 175.0,
        share: [0.1, 0.4, 0.9],
        n1: 1.0,
        n2: 1.5,
        theta1: 30.0,
        theta2: Some(19.471_220_634_490_69),
        direction: Some([0.0, -0.6, -0.8]),
        reflectance: 0.041_5,
    }));
    sketch.note(What::Conductor(Conductor {
        eta: [0.16, 0.42, 1.51],
        k: [3.65, 2.47, 1.87],
        n1: 1.0,
        theta: 0.0,
        reflectance: [0.95, 0.8, 0.4],
    }));
    sketch.note(What::Segment(segment()));
    let scatter = Scatter {
        medium: "mist".into(),
        number: 1,
        distance: 0.5,
        point: [0.0, 0.0, -1.0],
        chance: 0.3,
        density: 0.5,
        weight: [0.75; 3],
        colour: [0.1; 3],
    };
    sketch.with(What::Scatter(scatter), |s| {
        s.note(What::Phase(phase()));
    });
    sketch.note(What::Passage(Passage {
        medium: "mist".into(),
        behind: [1.0, 0.5, 0.0],
        passes: [0.472_366_552_741_014_7; 3],
        scattered: [0.1; 3],
        colour: [0.572_366_552_741_014_7, 0.336_183_276_370_507_4, 0.1],
    }));
    sketch.note(What::Overlap(Overlap { first: "bowl".into(), second: "water".into(), interval: [0.5, 1.5] }));
}

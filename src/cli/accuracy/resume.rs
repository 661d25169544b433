//! `--resume`: what an earlier run measured, read from its JSON.

use super::super::failure::{Failure, reason};
use super::data::{Repeats, SettingData};
use crate::laboratory::{Earlier, Setting, setting_named};
use crate::scene::MOST_PIXELS;
use serde::Deserialize;
use std::fs;
use std::path::Path;

/// What is read of the file. Errors are worked out anew, since the reference may have become better.
#[derive(Deserialize)]
struct File {
    scene: String,
    version: String,
    identity: String,
    width: u32,
    height: u32,
    #[serde(default)]
    seed: Option<u32>,
    pinned: Repeats,
    points: Vec<PointData>,
}

#[derive(Deserialize)]
struct PointData {
    settings: Vec<SettingData>,
    #[serde(flatten)]
    each: Repeats,
}

/// Reads an earlier run of the scene that this number stands for.
pub fn read(path: &Path, identity: u64) -> Result<Earlier, Failure> {
    let refuse = |why: &str| Failure::usage(format!("{} cannot be resumed: {why}", path.display()));
    let text = fs::read_to_string(path).map_err(|error| refuse(&reason(&error)))?;
    let file: File = serde_json::from_str(&text)
        .map_err(|error| refuse(&format!("it is not what `rayscope accuracy --format json` writes ({error})")))?;
    if file.version != env!("CARGO_PKG_VERSION") {
        let (before, now) = (&file.version, env!("CARGO_PKG_VERSION"));
        return Err(refuse(&format!("it was measured by version {before}, and this is {now}; measure anew")));
    }
    if file.identity != format!("{identity:016x}") {
        let scene = &file.scene;
        return Err(refuse(&format!(
            "it is of another scene, {scene}, or the scene or a file that it names was changed since; measure anew"
        )));
    }
    let pixels = u64::from(file.width) * u64::from(file.height);
    if pixels == 0 || pixels > MOST_PIXELS {
        return Err(refuse(&format!("its pictures have {} × {} pixels", file.width, file.height)));
    }
    let named = |data: &SettingData| {
        let unknown = || refuse(&format!("there is no setting `{}` of the knob `{}`", data.value, data.knob));
        setting_named(&data.knob, &data.value).ok_or_else(unknown)
    };
    let repeats = |point: &PointData| {
        let settings: Vec<Setting> = point.settings.iter().map(named).collect::<Result<_, _>>()?;
        Ok((settings, point.each.to_repeats()))
    };
    Ok(Earlier {
        size: [file.width, file.height],
        seed: file.seed,
        repeats: file.points.iter().map(repeats).collect::<Result<_, Failure>>()?,
        pinned: file.pinned.to_repeats(),
    })
}

//! `--accuracy` on the command line: a named profile, or the file of one.

use super::failure::{Failure, reason};
use crate::scene::{Profile, Scene};
use crate::share::link::Accuracy;
use clap::Args;
use std::fs;

/// The accuracy that a scene is looked at with.
#[derive(Args, Clone, Debug, Default)]
pub struct ProfileArgument {
    /// An accuracy profile: draft, standard or certified, or the file of one (`rayscope accuracy --profile` writes such files)
    #[arg(long, value_name = "PROFILE")]
    accuracy: Option<String>,
}

impl ProfileArgument {
    /// Names one from within the program.
    pub const fn named(accuracy: Option<String>) -> Self {
        Self { accuracy }
    }

    /// Whether there is one.
    pub const fn is_given(&self) -> bool {
        self.accuracy.is_some()
    }

    /// The profile as a link names it: by its name, or with the text of its file.
    pub fn for_link(&self) -> Result<Option<Accuracy>, Failure> {
        let Some(name) = &self.accuracy else { return Ok(None) };
        if Profile::NAMED.iter().any(|(known, _)| known == name) {
            return Ok(Some(Accuracy::Named(name.clone())));
        }
        let text = profile(name)?.to_json("An accuracy profile.").map_err(Failure::refused)?;
        Ok(Some(Accuracy::Text(text)))
    }

    /// The scene, looked at as the profile says.
    pub fn apply(&self, scene: Scene) -> Result<Scene, Failure> {
        match &self.accuracy {
            None => Ok(scene),
            Some(name) => Ok(scene.with_profile(&profile(name)?)),
        }
    }
}

/// The profile of that name, or in that file.
fn profile(name: &str) -> Result<Profile, Failure> {
    if let Some((_, profile)) = Profile::NAMED.iter().find(|(known, _)| *known == name) {
        return Ok(*profile);
    }
    let text = fs::read_to_string(name).map_err(|error| {
        let names = Profile::NAMED.map(|(name, _)| name).join(", ");
        Failure::usage(format!(
            "there is no accuracy profile {name}: the named ones are {names}, and as a file it cannot be read: {}",
            reason(&error)
        ))
    })?;
    Profile::read(&text, name)
        .map_err(|errors| Failure::usage(format!("the accuracy profile {name} cannot be used\n{errors}")))
}

//! From what a file says about a surface to what the tracer asks.

use super::SceneEnvironment;
use super::around_file::{EnvironmentFile, EnvironmentFilterFile, LayoutFile};
use super::coat::{Bumps, Coat, Texture};
use super::file::{MaterialFile, MirrorsFile};
use super::files::Files;
use super::pictures::{decode, decode_heights};
use super::problem::{Path, Problems};
use super::relief_file::BumpFile;
use super::relief_reader::{bump, grain};
use super::solid_texture_reader::{Fault, solid_texture};
use super::texture_file::{MapFile, TextureFile, WrapFile};
use crate::sample::Mask;
use crate::texture::image::{Affine, Environment, Filter, ImageTexture, Layout, Mapping, Texels, Wrap, Wraps};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Reads what surfaces carry, and gathers what is wrong with it.
pub(super) struct CoatReader<'a> {
    files: &'a dyn Files,
    problems: &'a mut Problems,
    /// The pictures that were read; none for those that cannot be.
    pictures: BTreeMap<String, Option<Arc<Texels>>>,
}

impl<'a> CoatReader<'a> {
    /// A reader whose pictures come from `files`.
    pub fn new(files: &'a dyn Files, problems: &'a mut Problems) -> Self {
        Self { files, problems, pictures: BTreeMap::new() }
    }

    /// What a material carries; none where that is nothing, or wrong.
    pub fn coat(&mut self, file: &MaterialFile, path: Path) -> Option<Box<Coat>> {
        let texture = file.texture.as_ref().and_then(|texture| self.texture(texture, path.field("texture")));
        let mirrors_environment = file.mirrors == MirrorsFile::Environment;
        let bump = file.bump.as_ref().and_then(|bump| self.bump(bump, path.field("bump")));
        let grain = file.frame.as_ref().map(grain);
        let frame = grain.and_then(|grain| self.without_fault(grain, path.field("frame")));
        let coat = Coat { texture, bump, frame, mirrors_environment, ..Coat::default() };
        (coat != Coat::default()).then(|| Box::new(coat))
    }

    /// The light from infinitely far away.
    pub fn environment(&mut self, file: &EnvironmentFile) -> Option<SceneEnvironment> {
        let path = Path::Root.field("environment");
        let texels = self.picture(&file.file, path.field("file"))?;
        let layout = match file.layout {
            LayoutFile::LatitudeLongitude => Layout::LatitudeLongitude,
            LayoutFile::Cross => Layout::Cross,
        };
        let map = self.right(Environment::new(texels, layout, file.turn), path.field("file"))?;
        Some(SceneEnvironment { map, averaged: file.filter == EnvironmentFilterFile::Area })
    }

    /// The picture of this name as a density: by the mean of its red, green and blue, which are linear.
    pub fn mask(&mut self, name: &str, path: Path) -> Option<Arc<Mask>> {
        let texels = self.picture(name, path)?;
        let [columns, rows] = texels.size();
        let edges = Wraps { columns: Wrap::Clamp, rows: Wrap::Clamp };
        let places = (0..rows).flat_map(|row| (0..columns).map(move |column| [i64::from(column), i64::from(row)]));
        let weights: Vec<f64> = places.map(|place| texels.at(place, edges).element_sum() / 3.0).collect();
        let made = Mask::new(columns as usize, &weights);
        let made = made.map_err(|why| format!("`{name}` cannot be an aperture: {why}; white should let light through"));
        self.right(made, path).map(Arc::new)
    }

    /// The picture of this name, read once.
    fn picture(&mut self, name: &str, path: Path) -> Option<Arc<Texels>> {
        if let Some(known) = self.pictures.get(name) {
            return known.clone();
        }
        let read = self.files.read(name).and_then(|bytes| decode(&bytes, name));
        let picture = self.right(read, path).map(Arc::new);
        self.pictures.insert(name.to_owned(), picture.clone());
        picture
    }

    /// The picture of this name, as heights.
    fn heights(&mut self, name: &str, path: Path) -> Option<Arc<Texels>> {
        let read = self.files.read(name).and_then(|bytes| decode_heights(&bytes, name));
        self.right(read, path).map(Arc::new)
    }

    /// What was made; where something was wrong with it, that is noted.
    fn right<T>(&mut self, made: Result<T, String>, path: Path) -> Option<T> {
        made.map_err(|message| {
            self.problems.add(path, message);
        })
        .ok()
    }

    fn texture(&mut self, file: &TextureFile, path: Path) -> Option<Texture> {
        if let TextureFile::Image { file, uv_from_st, parts, wrap, filter } = file {
            let texels = self.picture(file, path.field("file"))?;
            let mapping = self.mapping(uv_from_st, parts, path)?;
            let image = ImageTexture { texels, mapping, wraps: wraps(*wrap), filter: Filter::from(*filter) };
            return Some(Texture::Image { image, parts: parts.keys().cloned().collect() });
        }
        self.without_fault(solid_texture(file)?, path).map(|moving| Texture::Solid(Box::new(moving)))
    }

    fn bump(&mut self, file: &BumpFile, path: Path) -> Option<Bumps> {
        if let BumpFile::Image { height, file, uv_from_st, parts, wrap } = file {
            let texels = self.heights(file, path.field("file"))?;
            let mapping = self.mapping(uv_from_st, parts, path)?;
            let image = ImageTexture { texels, mapping, wraps: wraps(*wrap), filter: Filter::Bilinear };
            return Some(Bumps::Image { image, parts: parts.keys().cloned().collect(), height: *height });
        }
        let (bump, time_per_frame) = self.without_fault(bump(file)?, path)?;
        Some(Bumps::Procedure { bump, time_per_frame })
    }

    /// What was made; where a field of it was wrong, that is noted.
    fn without_fault<T>(&mut self, made: Result<T, Fault>, path: Path) -> Option<T> {
        made.map_err(|(field, message)| {
            self.problems.add(path.field(field), message);
        })
        .ok()
    }

    fn mapping(&mut self, whole: &MapFile, parts: &BTreeMap<String, MapFile>, path: Path) -> Option<Mapping> {
        let mut mapping = self.right(Mapping::new(Affine::new(*whole)), path.field("uv_from_st"))?;
        for (number, (name, map)) in (1..).zip(parts) {
            mapping = self.right(mapping.with_part(number, Affine::new(*map)), path.field("parts").field(name))?;
        }
        Some(mapping)
    }
}

fn wraps(file: WrapFile) -> Wraps {
    let wrap = match file {
        WrapFile::Repeat => Wrap::Repeat,
        WrapFile::Mirror => Wrap::Mirror,
        WrapFile::Clamp => Wrap::Clamp,
    };
    Wraps { columns: wrap, rows: wrap }
}

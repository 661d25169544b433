//! What the surface carries at the hit (§ 6.3): the bump and the grain that turn its frame, and the texture that gives its
//! colour. Where a material carries nothing, nothing of this is asked.

use super::beam::Corner;
use super::calls::Repertoire;
use super::closest::Surface;
use super::ray::Tracer;
use crate::record::{self, Effect, Entry, Recorder, What};
use crate::scene::{Bumps, Coat, Effects, Material, MovingTexture, Rgb, Texture, mapped_part};
use crate::shape::Primitive;
use crate::texture::image::{ImageTexture, Place};
use crate::texture::relief::{BumpDerivative, Frame, Rise, Site, raised, turning};
use glam::{DAffine3, DVec2, DVec3};

/// The surface, ready for the lights.
pub(super) struct Finish<'a> {
    pub material: &'a Material,
    /// The ambient colour, with the texture's.
    pub ambient: Rgb,
    /// The diffuse colour, with the texture's.
    pub diffuse: Rgb,
    /// The frame that draws out highlights, with its roughness along the grain and across it.
    pub grain: Option<(Frame, [f64; 2])>,
}

impl<'a, E: Repertoire> Tracer<'a, E> {
    /// Finishes the surface: gives it the normal that shading uses, and returns its colours.
    pub(super) fn finish<R: Recorder>(
        &self,
        surface: &mut Surface,
        corners: Option<&[Corner; 4]>,
        recorder: &mut R,
    ) -> Finish<'a> {
        let material = &self.scene.materials[surface.material];
        let mut finish = Finish { material, ambient: material.ambient, diffuse: material.diffuse, grain: None };
        if self.calls_for_any(Effects::COATS)
            && let Some(coat) = &material.coat
        {
            self.lay_on(coat, surface, corners, &mut finish, recorder);
        }
        finish
    }

    /// Puts what the material carries on the surface.
    #[inline(never)]
    fn lay_on<R: Recorder>(
        &self,
        coat: &Coat,
        surface: &mut Surface,
        corners: Option<&[Corner; 4]>,
        finish: &mut Finish,
        recorder: &mut R,
    ) {
        finish.grain = self.turn(surface, coat, recorder);
        if let Some(texture) = coat.texture.as_ref().filter(|texture| self.calls_for(texture.effect())) {
            let pigment = self.pigment(surface, texture, corners, recorder);
            finish.ambient *= pigment;
            finish.diffuse *= pigment;
        }
    }

    /// Turns the normal by what the material's bump says, and the frame by its grain, which is returned with its roughness.
    fn turn<R: Recorder>(&self, surface: &mut Surface, coat: &Coat, recorder: &mut R) -> Option<(Frame, [f64; 2])> {
        let bump = coat.bump.as_ref().filter(|_| self.calls_for(Effect::Bumps));
        let frame = coat.frame.as_ref().filter(|_| self.calls_for(Effect::Frames));
        if bump.is_none() && frame.is_none() {
            return None;
        }
        let mut site = self.site(surface);
        if let Some(bump) = bump {
            Self::enter(Effect::Bumps, recorder);
            site.normal = self.bumped(surface, (bump, coat.bump_derivative), &site, recorder);
        }
        let frame = frame.map(|coat| {
            Self::enter(Effect::Frames, recorder);
            (coat.grain.frame(&site, coat.roughness, recorder), coat.roughness)
        });
        let normal = frame.map_or(site.normal, |(frame, _)| frame.normal);
        // From within, all of it is seen from behind.
        let is_behind = surface.n_geometric.dot(surface.n_shading) < 0.0;
        surface.n_shading = if is_behind { -normal } else { normal };
        frame.map(|(frame, roughness)| (Frame { normal: surface.n_shading, ..frame }, roughness))
    }

    /// The place on the surface as bumps and grain ask for it.
    fn site(&self, surface: &Surface) -> Site {
        let leaf = self.leaf(surface.object, &surface.boundary);
        let (generic, part) = (leaf.placement.generic_point(surface.point), surface.boundary.part);
        let world_from_generic = leaf.placement.world_from_generic();
        let object_from_world = self.object_from_world(surface);
        Site {
            texture_point: object_from_world.transform_point3(surface.point),
            texture_from_world: object_from_world.matrix3,
            uv: leaf.shape.uv(generic, part),
            tangents: leaf.shape.tangents(generic, part).map(|tangent| world_from_generic.transform_vector3(tangent)),
            normal: surface.n_geometric,
        }
    }

    fn bumped<R: Recorder>(
        &self,
        surface: &Surface,
        (bumps, derivative): (&Bumps, BumpDerivative),
        site: &Site,
        recorder: &mut R,
    ) -> DVec3 {
        let leaf = self.leaf(surface.object, &surface.boundary);
        let part = surface.boundary.part;
        let turning = || {
            turning(site.tangents, |beside| {
                let generic = leaf.placement.generic_point(surface.point + beside);
                let normal = leaf.placement.world_normal(leaf.shape.normal(generic, part));
                if surface.boundary.flipped { -normal } else { normal }
            })
        };
        match bumps {
            Bumps::Procedure { bump, .. } => bump.normal(site, derivative, turning, recorder),
            Bumps::Image { image, parts, height } => {
                let part = mapped_part(parts, leaf.part(&surface.boundary));
                let (share, slopes) = image.height_and_slopes(site.uv, part);
                let rise = Rise { height: height * share, slopes: slopes.map(|slope| height * slope) };
                raised((bumps.kind(), derivative), site, rise, turning, recorder)
            }
        }
    }

    /// The texture's colour.
    fn pigment<R: Recorder>(
        &self,
        surface: &Surface,
        texture: &Texture,
        corners: Option<&[Corner; 4]>,
        recorder: &mut R,
    ) -> Rgb {
        Self::enter(texture.effect(), recorder);
        match texture {
            Texture::Image { image, parts } => {
                let uv = self.uv(surface, surface.point);
                recorder.event(
                    |recorder| self.image_colour(surface, uv, (image, parts), corners, recorder),
                    |colour| self.describe_texture(surface, "image", uv.extend(0.0), *colour),
                )
            }
            Texture::Solid(moving) => {
                let point = self.texture_point(surface, moving);
                recorder.event(
                    |recorder| moving.texture.colour(point, recorder),
                    |colour| {
                        let entry = self.describe_texture(surface, moving.kind(), point, *colour);
                        moving.texture.lines(point, entry)
                    },
                )
            }
        }
    }

    fn image_colour(
        &self,
        surface: &Surface,
        uv: DVec2,
        (image, parts): (&ImageTexture, &[String]),
        corners: Option<&[Corner; 4]>,
        recorder: &mut impl Recorder,
    ) -> Rgb {
        let leaf = self.leaf(surface.object, &surface.boundary);
        let part_name = leaf.part(&surface.boundary);
        let place = Place {
            uv,
            part: mapped_part(parts, part_name),
            part_name,
            corners: corners.map(|corners| corners.map(|corner| self.uv(surface, corner.point))),
            off_the_surface: corners.map_or(0, |corners| corners.iter().filter(|corner| !corner.on_surface).count()),
            period: leaf.shape.uv_period(surface.boundary.part),
        };
        image.colour(&place, recorder)
    }

    /// (u, v) of a point on the part of the primitive that was hit.
    fn uv(&self, surface: &Surface, point: DVec3) -> DVec2 {
        let leaf = self.leaf(surface.object, &surface.boundary);
        leaf.shape.uv(leaf.placement.generic_point(point), surface.boundary.part)
    }

    /// The hit in the space of a solid texture.
    fn texture_point(&self, surface: &Surface, moving: &MovingTexture) -> DVec3 {
        let in_object = self.object_from_world(surface).transform_point3(surface.point);
        moving.texture_from_object.transform_point3(in_object)
    }

    /// From the world to the space of the solid that names the surface's material.
    fn object_from_world(&self, surface: &Surface) -> DAffine3 {
        let coats = self.scene.objects[surface.object].coats.as_deref().unwrap_or_default();
        coats.get(surface.boundary.leaf).map_or(DAffine3::IDENTITY, |leaf| leaf.object_from_world)
    }

    fn describe_texture(&self, surface: &Surface, name: &str, point: DVec3, colour: Rgb) -> Entry {
        let material = self.material(surface);
        let bindings = [
            ("m_a", material.ambient.to_array().into()),
            ("m_d", material.diffuse.to_array().into()),
            ("C", colour.to_array().into()),
        ];
        Entry::new(What::Texture(record::Texture {
            texture: name.to_owned(),
            point: point.to_array(),
            colour: colour.to_array(),
        }))
        .line("k_a", "m_a C", &bindings, (material.ambient * colour).to_array())
        .line("k_d", "m_d C", &bindings, (material.diffuse * colour).to_array())
    }
}

//! Pictures of the workbench without a window or a graphics card: egui's triangles, filled in here one by one.

use egui::epaint::{ClippedPrimitive, ImageData, Mesh, Primitive, Vertex};
use egui::{Color32, ColorImage, Context, FullOutput, Rect, TextureFilter, TextureId, TextureOptions, TexturesDelta};
use egui_kittest::TestRenderer;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The textures of a workbench, kept so that pictures can be taken of it.
#[derive(Clone, Default)]
pub struct Camera {
    textures: Rc<RefCell<BTreeMap<TextureId, (ColorImage, TextureOptions)>>>,
}

impl TestRenderer for Camera {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        let mut textures = self.textures.borrow_mut();
        for (id, changes) in delta.set.drain() {
            for change in changes {
                let ImageData::Color(image) = change.image;
                match (change.pos, textures.get_mut(&id)) {
                    (Some([left, top]), Some((whole, _))) => paste(whole, &image, left, top),
                    _ => {
                        textures.insert(id, (ColorImage::clone(&image), change.options));
                    }
                }
            }
        }
        for id in delta.free.drain() {
            textures.remove(&id);
        }
    }
}

fn paste(whole: &mut ColorImage, part: &ColorImage, left: usize, top: usize) {
    let [width, height] = part.size;
    for row in 0..height {
        let at = (top + row) * whole.size[0] + left;
        whole.pixels[at..at + width].copy_from_slice(&part.pixels[row * width..(row + 1) * width]);
    }
}

impl Camera {
    /// What is on screen, `size` pixels large, one row after the other.
    pub fn picture(&self, ctx: &Context, output: &FullOutput, size: [usize; 2]) -> ColorImage {
        let scale = ctx.pixels_per_point();
        let mut canvas = ColorImage::filled(size, Color32::BLACK);
        for ClippedPrimitive { clip_rect, primitive } in ctx.tessellate(output.shapes.clone(), scale) {
            if let Primitive::Mesh(mesh) = primitive {
                self.mesh(&mut canvas, &mesh, scaled(clip_rect, scale), scale);
            }
        }
        canvas
    }

    fn mesh(&self, canvas: &mut ColorImage, mesh: &Mesh, clip: Rect, scale: f32) {
        let textures = self.textures.borrow();
        let Some((texture, options)) = textures.get(&mesh.texture_id) else { return };
        for corners in mesh.indices.chunks_exact(3) {
            let corners = [0, 1, 2].map(|k| mesh.vertices[corners[k] as usize]);
            triangle(canvas, corners, clip, scale, |uv| look_up(texture, *options, uv));
        }
    }
}

fn scaled(rect: Rect, scale: f32) -> Rect {
    Rect::from_min_max((rect.min.to_vec2() * scale).to_pos2(), (rect.max.to_vec2() * scale).to_pos2())
}

/// Fills the pixels whose middles lie in a triangle; of two triangles that share an edge, one gets those on the edge.
fn triangle(
    canvas: &mut ColorImage,
    mut corners: [Vertex; 3],
    clip: Rect,
    scale: f32,
    texel: impl Fn([f32; 2]) -> [f32; 4],
) {
    let at = |v: &Vertex| [f64::from(v.pos.x * scale), f64::from(v.pos.y * scale)];
    let edge = |a: [f64; 2], b: [f64; 2], p: [f64; 2]| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    let mut p = [at(&corners[0]), at(&corners[1]), at(&corners[2])];
    if edge(p[0], p[1], p[2]) < 0.0 {
        corners.swap(1, 2);
        p.swap(1, 2);
    }
    let area = edge(p[0], p[1], p[2]);
    if area <= 0.0 {
        return;
    }
    let [width, height] = canvas.size;
    let span = |axis: usize, low: f32, high: f32, end: usize| {
        let least = p.iter().map(|q| q[axis]).fold(f64::INFINITY, f64::min).max(f64::from(low.round()));
        let most = p.iter().map(|q| q[axis]).fold(f64::NEG_INFINITY, f64::max).min(f64::from(high.round()));
        (least.floor().max(0.0) as usize, (most.ceil().max(0.0) as usize).min(end))
    };
    let ((left, right), (top, bottom)) =
        (span(0, clip.min.x, clip.max.x, width), span(1, clip.min.y, clip.max.y, height));
    // An edge that goes up or straight to the left owns its pixels.
    let owns = |a: [f64; 2], b: [f64; 2]| b[1] < a[1] || (b[1] == a[1] && b[0] > a[0]);
    for y in top..bottom {
        for x in left..right {
            let middle = [x as f64 + 0.5, y as f64 + 0.5];
            let shares = [[1, 2], [2, 0], [0, 1]].map(|[a, b]| (edge(p[a], p[b], middle), owns(p[a], p[b])));
            if shares.iter().any(|&(share, owned)| share < 0.0 || (share == 0.0 && !owned)) {
                continue;
            }
            let weights = shares.map(|(share, _)| (share / area) as f32);
            let mixed = |value: &dyn Fn(&Vertex) -> f32| (0..3).map(|k| weights[k] * value(&corners[k])).sum::<f32>();
            let colour: [f32; 4] = std::array::from_fn(|c| mixed(&|v| f32::from(v.color.to_array()[c])) / 255.0);
            let texel = texel([mixed(&|v| v.uv.x), mixed(&|v| v.uv.y)]);
            blend(&mut canvas.pixels[y * width + x], std::array::from_fn(|c| colour[c] * texel[c]));
        }
    }
}

/// Both premultiplied, in the gamma space that egui blends in.
fn blend(pixel: &mut Color32, source: [f32; 4]) {
    let below = pixel.to_array().map(|c| f32::from(c) / 255.0);
    let mixed: [u8; 4] =
        std::array::from_fn(|c| ((source[c] + below[c] * (1.0 - source[3])).clamp(0.0, 1.0) * 255.0).round() as u8);
    *pixel = Color32::from_rgba_premultiplied(mixed[0], mixed[1], mixed[2], 255);
}

fn look_up(texture: &ColorImage, options: TextureOptions, [u, v]: [f32; 2]) -> [f32; 4] {
    let [width, height] = texture.size;
    let texel = |x: isize, y: isize| {
        let x = x.clamp(0, width as isize - 1) as usize;
        let y = y.clamp(0, height as isize - 1) as usize;
        texture.pixels[y * width + x].to_array().map(|c| f32::from(c) / 255.0)
    };
    let (x, y) = (u * width as f32, v * height as f32);
    if options.magnification == TextureFilter::Nearest {
        return texel(x.floor() as isize, y.floor() as isize);
    }
    let (x, y) = (x - 0.5, y - 0.5);
    let (left, top) = (x.floor(), y.floor());
    let (s, t) = (x - left, y - top);
    let (left, top) = (left as isize, top as isize);
    let corners = [texel(left, top), texel(left + 1, top), texel(left, top + 1), texel(left + 1, top + 1)];
    std::array::from_fn(|c| {
        let upper = corners[0][c] * (1.0 - s) + corners[1][c] * s;
        let lower = corners[2][c] * (1.0 - s) + corners[3][c] * s;
        upper * (1.0 - t) + lower * t
    })
}

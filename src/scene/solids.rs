//! From solids in a file to placed primitives in a binary tree.

use super::around_file::DetailFile;
use super::check::check;
use super::lenient::Lenient;
use super::problem::{Path, Problems};
use super::rules::Rules;
use super::solid_file::{Common, Parameter, SolidFile};
use super::{Detail, Material};
use crate::csg::{Leaf, Placement, Solid};
use crate::for_each_shape;
use crate::record::Operator;
use crate::shape::{HalfSpace, Part, Primitive, Shape};
use glam::{DAffine3, DVec2};
use serde::Deserialize;
use serde_json::{Map, Value};
use std::sync::LazyLock;

/// Levels of the binary tree. Deeper trees could exhaust a thread's stack while a ray is followed through them; a list of
/// `of` adds a level with each solid in it, so fewer would soon be felt.
const MOST_LEVELS: usize = 256;

/// Primitives of one file, copies counted. Copies of copies grow without bound otherwise; these fill about 200 megabytes.
const MOST_PRIMITIVES: usize = 150_000;

/// A solid and what covers its leaves.
pub(super) struct Compiled {
    pub solid: Solid,
    pub covers: Vec<Cover>,
    levels: usize,
}

/// What details lie on.
#[derive(Clone, Copy)]
struct Ground<'a> {
    shape: &'a Shape,
    material: usize,
}

/// What covers a leaf.
pub(super) struct Cover {
    /// Its material; the first one where materials do not matter.
    pub material: usize,
    /// From the space of the solid that names the material to the world: what is carved out of one block has one space.
    pub world_from_object: DAffine3,
    /// Polygons on its flat parts.
    pub details: Vec<Detail>,
}

/// What a solid takes over from those around it.
#[derive(Clone, Copy)]
pub(super) struct Around<'a> {
    affine: DAffine3,
    material: Option<(usize, DAffine3)>,
    /// The name to use where it has none of its own.
    name: Option<&'a str>,
    part_of_compound: bool,
    level: usize,
}

impl Around<'_> {
    /// An object by itself.
    pub const NOTHING: Self =
        Self { affine: DAffine3::IDENTITY, material: None, name: None, part_of_compound: false, level: 0 };
}

/// Reads solids, and gathers what is wrong with them.
pub(super) struct SolidReader<'a> {
    named: &'a Map<String, Value>,
    /// The materials in the order of their names; none where materials do not matter.
    materials: Option<&'a [Material]>,
    problems: &'a mut Problems,
    /// Whether copies are put in place of their originals: not where they go round in a circle.
    pub follow_copies: bool,
    primitives: usize,
}

/// Compiles the geometry of a solid. Materials are not looked at.
///
/// # Errors
/// All that is wrong, on one line, each with its place in the JSON.
pub fn compile_solid(value: &Value) -> Result<Solid, String> {
    static RULES: LazyLock<Rules> = LazyLock::new(|| Rules::new(schemars::schema_for!(SolidFile).as_value()));
    let mut problems = Problems::default();
    check(&RULES, &RULES.root, value, Path::Root, &mut problems);
    let named = Map::new();
    let compiled = if problems.list.is_empty() {
        SolidReader::new(&named, None, &mut problems).solid(value, Path::Root, Around::NOTHING)
    } else {
        None
    };
    match compiled {
        Some(compiled) if problems.list.is_empty() => Ok(compiled.solid),
        _ => Err(problems.list.iter().map(ToString::to_string).collect::<Vec<_>>().join(" | ")),
    }
}

impl<'a> SolidReader<'a> {
    /// A reader for a file with these `named` solids and these materials.
    pub fn new(named: &'a Map<String, Value>, materials: Option<&'a [Material]>, problems: &'a mut Problems) -> Self {
        Self { named, materials, problems, follow_copies: true, primitives: 0 }
    }

    /// Looks at each named solid by itself, so that what is wrong with one comes out even if nothing is a copy of it.
    pub fn look_at_named(named: &'a Map<String, Value>, problems: &'a mut Problems) {
        let path = Path::Root.field("solids");
        let mut reader = Self { follow_copies: false, ..Self::new(named, None, problems) };
        for (name, solid) in named {
            reader.solid(solid, path.field(name), Around::NOTHING);
        }
    }

    /// Compiles the solid at `path`; none if something is wrong with it.
    pub fn solid(&mut self, value: &Value, path: Path, around: Around) -> Option<Compiled> {
        let common = Common::deserialize(value).ok()?;
        let shape = value.get("shape").and_then(Value::as_str).filter(|shape| is_known(shape))?;
        if self.primitives > MOST_PRIMITIVES {
            return None;
        }
        if around.level > MOST_LEVELS {
            self.problems.add(path, format!("solids are nested more than {MOST_LEVELS} deep"));
            return None;
        }
        if around.level > 0 && common.priority.is_some() {
            self.problems
                .add_at_name(path.field("priority"), "only an object has a priority, not a part of it")
                .help("put `priority` on the object in `objects`");
        }
        let affine = self.transform(&common, path);
        let material = self.material(&common.material, path);
        let name = common.name.0.as_ref().filter(|name| !name.is_empty()).cloned();
        let affine = around.affine * affine?;
        let here = Around {
            affine,
            material: material.map(|material| (material, affine)).or(around.material),
            name: around.name.or(name.as_deref()),
            level: around.level + 1,
            ..around
        };
        let is_primitive = Shape::NAMES.contains(&shape);
        if !is_primitive && common.details.0.as_ref().is_some_and(|details| !details.is_empty()) {
            self.problems
                .add_at_name(path.field("details"), format!("a {shape} has no faces of its own for details to lie on"))
                .help("put `details` on one of the primitives in it");
        }
        match shape {
            "union" => self.compound(Operator::Union, value, path, here),
            "intersection" => self.compound(Operator::Intersection, value, path, here),
            "difference" => self.compound(Operator::Difference, value, path, here),
            "copy" => self.copy(value, path, here),
            _ => self.primitive(shape, value, &common, path, here),
        }
    }

    fn transform(&mut self, common: &Common, path: Path) -> Option<DAffine3> {
        let (list, mut affine) = (path.field("transform"), Some(DAffine3::IDENTITY));
        for (i, step) in common.transform.0.as_ref()?.iter().enumerate() {
            let step = step.0?;
            match step.affine() {
                Ok(map) => affine = affine.map(|affine| map * affine),
                Err((field, message)) => {
                    let (item, name) = (list.item(i), step.name());
                    let at = item.field(name);
                    self.problems.add(if field.is_empty() { at } else { at.field(field) }, message);
                    affine = None;
                }
            }
        }
        affine
    }

    fn material(&mut self, name: &Lenient<String>, path: Path) -> Option<usize> {
        let name = name.0.as_deref().filter(|name| !name.is_empty())?;
        let materials = self.materials?;
        let found = place_of(materials, name);
        if found.is_none() {
            self.problems.add(path.field("material"), format!("unknown material `{name}`")).suggest(
                "materials",
                name,
                materials.iter().map(|material| material.name.as_str()),
            );
        }
        // The first material stands in, so that the same mistake is not reported as a missing one.
        found.or(Some(0))
    }

    /// Folds the operands from the left: ((a OP b) OP c) OP …
    fn compound(&mut self, operator: Operator, value: &Value, path: Path, around: Around) -> Option<Compiled> {
        let list = path.field("of");
        let name = around.name.unwrap_or(operator.name());
        let inner = Around { name: None, part_of_compound: true, ..around };
        let operands = value.get("of")?.as_array()?;
        let compiled: Vec<_> =
            operands.iter().enumerate().map(|(i, operand)| self.solid(operand, list.item(i), inner)).collect();
        let mut operands = compiled.into_iter().collect::<Option<Vec<_>>>()?.into_iter();
        let mut result = operands.next()?;
        let pairs = operands.len();
        for (i, operand) in operands.enumerate() {
            // The whole has the name; what the fold makes on the way has the operator's.
            let name = if i + 1 == pairs { name } else { operator.name() };
            result.levels = result.levels.max(operand.levels) + 1;
            if result.levels > MOST_LEVELS {
                self.problems
                    .add(path, format!("the tree of this solid has more than {MOST_LEVELS} levels"))
                    .help("each solid in `of` adds a level: make groups of them, or several objects");
                return None;
            }
            result.solid = Solid::pair(name, operator, result.solid, operand.solid);
            result.covers.extend(operand.covers);
        }
        Some(result)
    }

    fn copy(&mut self, value: &Value, path: Path, around: Around) -> Option<Compiled> {
        let name = value.get("solid")?.as_str()?;
        let Some(original) = self.named.get(name) else {
            let known = self.named.keys().map(String::as_str);
            self.problems.add(path.field("solid"), format!("unknown solid `{name}`")).suggest(
                "named solids",
                name,
                known,
            );
            return None;
        };
        if !self.follow_copies {
            return None;
        }
        let own_name = original.get("name").and_then(Value::as_str);
        let inner = Around { name: around.name.or(own_name).or(Some(name)), ..around };
        self.solid(original, Path::Root.field("solids").field(name), inner)
    }

    fn primitive(
        &mut self,
        shape: &str,
        value: &Value,
        common: &Common,
        path: Path,
        around: Around,
    ) -> Option<Compiled> {
        self.primitives += 1;
        if self.primitives > MOST_PRIMITIVES {
            self.problems.add(path, format!("the scene has more than {MOST_PRIMITIVES} primitives, copies counted"));
            return None;
        }
        if around.part_of_compound && shape == "square" {
            self.problems
                .add(path, "a square has no inside, so it cannot be part of a union, intersection or difference")
                .help("use a thin cube, or make the square an object of its own");
        }
        let name = around.name.unwrap_or(shape);
        if self.materials.is_some() && around.material.is_none() {
            self.problems
                .add(path, format!("`{name}` has no material"))
                .help("give it a `material`, or one of the solids around it");
        }
        let shape = read_shape(shape, value, path, self.problems)?;
        let placement = match Placement::new(around.affine) {
            Ok(placement) => placement,
            Err(message) => {
                self.problems.add(path.field("transform"), message);
                return None;
            }
        };
        let (material, world_from_object) = around.material.unwrap_or((0, DAffine3::IDENTITY));
        let ground = Ground { shape: &shape, material };
        let details = self.details(&common.details, path.field("details"), ground);
        let solid = Solid::leaf(Leaf::new(name, shape, placement));
        Some(Compiled { solid, covers: vec![Cover { material, world_from_object, details }], levels: 1 })
    }

    /// The polygons on a primitive's flat parts.
    fn details(&mut self, files: &Lenient<Vec<Lenient<DetailFile>>>, path: Path, ground: Ground) -> Vec<Detail> {
        let files = files.0.iter().flatten().enumerate();
        files.filter_map(|(i, file)| self.detail(file.0.as_ref()?, path.item(i), ground, None)).collect()
    }

    /// One polygon, with those that lie on it; `below` is the part of the one that it lies on.
    fn detail(&mut self, file: &DetailFile, path: Path, ground: Ground, below: Option<Part>) -> Option<Detail> {
        let part = match below {
            Some(part) => part,
            None => flat_part(ground.shape, &file.part, path, self.problems)?,
        };
        let material = self.material(&Lenient(Some(file.material.clone())), path)?;
        let lets_through = |material: usize| {
            self.materials.and_then(|materials| materials.get(material)).is_some_and(|m| m.transparency > 0.0)
        };
        if lets_through(material) && !lets_through(ground.material) {
            self.problems
                .add(
                    path.field("material"),
                    "a detail on an opaque solid cannot be transparent: nothing lies behind it",
                )
                .help("give the detail an opaque material, or the solid a transparent one");
        }
        let polygon: Vec<_> = file.polygon.iter().map(|&corner| DVec2::from_array(corner)).collect();
        let details = path.field("details");
        let above = file.details.iter().enumerate();
        let details = above.filter_map(|(i, file)| self.detail(file, details.item(i), ground, Some(part))).collect();
        let repeat = file.repeat.map(|[u, v]| DVec2::new(f64::from(u), f64::from(v)));
        Some(Detail { part, polygon, repeat, material, details })
    }
}

/// The place of a material among those in the order of their names.
pub(super) fn place_of(materials: &[Material], name: &str) -> Option<usize> {
    materials.binary_search_by(|material| material.name.as_str().cmp(name)).ok()
}

/// The flat part of this name; the only part where none is named.
fn flat_part(shape: &Shape, name: &str, path: Path, problems: &mut Problems) -> Option<Part> {
    let parts = shape.parts();
    let flat: Vec<_> = (0..).zip(&parts).filter(|(part, _)| shape.is_flat(*part)).collect();
    if let (true, [(only, _)]) = (name.is_empty(), &flat[..]) {
        return Some(*only);
    }
    if let Some((part, _)) = flat.iter().find(|(_, flat)| *flat == name) {
        return Some(*part);
    }
    let known: Vec<_> = flat.iter().map(|(_, name)| format!("`{name}`")).collect();
    let (message, help) = if known.is_empty() {
        (format!("a {} has no flat part for a detail to lie on", shape.name()), "use an image texture".to_owned())
    } else if name.is_empty() {
        ("the detail does not say which part it lies on".to_owned(), format!("`part` is one of {}", known.join(", ")))
    } else {
        let is_round = parts.iter().any(|part| part == name);
        let what = if is_round { format!("`{name}` is not flat") } else { format!("unknown part `{name}`") };
        (what, format!("a detail can lie on {}", known.join(", ")))
    };
    problems.add(path, message).help(help);
    None
}

fn is_known(shape: &str) -> bool {
    Shape::NAMES.contains(&shape) || ["union", "intersection", "difference", "copy"].contains(&shape)
}

macro_rules! define_read_shape {
    ($($variant:ident $name:literal $about:literal { $($parameter:ident : $type:ty = $doc:literal,)* })*) => {
        fn read_shape(shape: &str, value: &Value, path: Path, problems: &mut Problems) -> Option<Shape> {
            let (made, parameters): (Result<Shape, String>, &[&str]) = match shape {
                $($name => {
                    $(let $parameter = read_parameter::<$type>(value, stringify!($parameter))?;)*
                    (crate::shape::$variant::new($($parameter),*).map(Shape::$variant), &[$(stringify!($parameter)),*])
                })*
                _ => return None,
            };
            made.map_err(|message| {
                problems.add(path.field(parameter_at_fault(&message, parameters).unwrap_or("shape")), message);
            }).ok()
        }
    };
}

for_each_shape!(define_read_shape);

fn read_parameter<T: Parameter>(value: &Value, name: &str) -> Option<T> {
    T::File::deserialize(value.get(name)?).ok().map(T::from_file)
}

/// The parameter that a message is about: the only one, or the first that it names.
fn parameter_at_fault<'p>(message: &str, parameters: &[&'p str]) -> Option<&'p str> {
    if let [only] = parameters {
        return Some(only);
    }
    message.split(|c: char| !c.is_alphanumeric()).find_map(|word| parameters.iter().copied().find(|name| *name == word))
}

/// Notes each circle of named solids that are copies of one another, once.
///
/// Returns whether there is one: then copies must not be followed.
pub(super) fn find_circles(named: &Map<String, Value>, problems: &mut Problems) -> bool {
    let before = problems.list.len();
    let mut search = CircleSearch { named, open: Vec::new(), done: Vec::new(), problems };
    for name in named.keys() {
        search.visit(name);
    }
    search.problems.list.len() > before
}

struct CircleSearch<'a> {
    named: &'a Map<String, Value>,
    open: Vec<&'a str>,
    done: Vec<&'a str>,
    problems: &'a mut Problems,
}

impl<'a> CircleSearch<'a> {
    fn visit(&mut self, name: &'a str) {
        let Some(solid) = self.named.get(name).filter(|_| !self.done.contains(&name)) else { return };
        self.open.push(name);
        self.look_for_copies(solid, Path::Root.field("solids").field(name));
        self.open.pop();
        self.done.push(name);
    }

    fn look_for_copies(&mut self, solid: &'a Value, path: Path) {
        if let (Some("copy"), Some(name)) = (text(solid, "shape"), text(solid, "solid")) {
            match self.open.iter().position(|open| *open == name) {
                Some(start) => {
                    let circle = [&self.open[start..], &[name]].concat().join(" → ");
                    self.problems
                        .add(
                            path.field("solid"),
                            format!("the named solids are copies of themselves in a circle: {circle}"),
                        )
                        .help("a solid cannot be a part of itself; make one of them without the other");
                }
                None => self.visit(name),
            }
        }
        let list = path.field("of");
        for (i, part) in solid.get("of").and_then(Value::as_array).into_iter().flatten().enumerate() {
            self.look_for_copies(part, list.item(i));
        }
    }
}

fn text<'a>(value: &'a Value, field: &str) -> Option<&'a str> {
    value.get(field).and_then(Value::as_str)
}

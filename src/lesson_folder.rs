//! Lessons on disk: those of a folder, one lesson's folder, or those that come with the program; and the scenes beside them.

use crate::folder::{Outside, files_of_scene};
use crate::lesson::{Course, EMBEDDED, LessonText, Shelf};
use crate::scene::{EmbeddedFiles, Files};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Lessons, and where they lie.
pub struct Lessons {
    /// The lessons, read.
    pub course: Course,
    /// The scenes beside them.
    pub shelf: LessonShelf,
    /// The lesson that was asked for, where one was and not a whole folder.
    pub chosen: Option<String>,
}

/// The scenes beside lessons: on disk for those that were read from there, within the program for the others.
#[derive(Clone, Debug, Default)]
pub struct LessonShelf {
    folders: BTreeMap<String, PathBuf>,
}

impl Lessons {
    /// The course that comes with the program.
    #[must_use]
    pub fn embedded() -> Self {
        Self { course: Course::embedded(), shelf: LessonShelf::default(), chosen: None }
    }

    /// What `name` says: a lesson of the course by its name, the folder or the file of a lesson, or a folder of lessons.
    ///
    /// # Errors
    /// If there is no such thing, or it cannot be read; with what was looked for.
    pub fn named(name: &str) -> Result<Self, String> {
        let path = Path::new(name);
        if path.is_file() {
            let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
            return Self::one(folder);
        }
        if path.join("lesson.md").is_file() {
            return Self::one(path);
        }
        if path.is_dir() {
            return Self::folder(path);
        }
        let lessons = Self::embedded();
        match lessons.course.lesson(name) {
            Some(lesson) => Ok(Self { chosen: Some(lesson.id.clone()), ..lessons }),
            None => Err(format!(
                "there is no lesson {name}: `rayscope lesson list` lists those of the course, and there is neither a file \
                 nor a folder of that name"
            )),
        }
    }

    /// One lesson, with the lessons beside it: what it needs is among them.
    fn one(folder: &Path) -> Result<Self, String> {
        let full = folder.canonicalize().map_err(|error| cannot(folder, &error))?;
        let id = id_of(&full);
        let beside = full.parent().map(Path::to_owned).unwrap_or_default();
        let mut texts = disk_texts(&beside).unwrap_or_default();
        texts.retain(|text| text.id != id);
        let mut folders = folders_of(&beside, &texts);
        folders.insert(id.clone(), folder.to_owned());
        // Messages name the file as it was asked for.
        let own = text_of(folder, &id)?;
        let file = own.file.clone();
        texts.push(own);
        texts.sort_by(|a, b| a.id.cmp(&b.id));
        let mut course = Course::read(&texts, Some(("glossary.md", &glossary_text(&beside))));
        course.findings.retain(|finding| finding.file == file);
        course.beside = program_ids();
        Ok(Self { course, shelf: LessonShelf { folders }, chosen: Some(id) })
    }

    fn folder(folder: &Path) -> Result<Self, String> {
        let texts = disk_texts(folder)?;
        if texts.is_empty() {
            return Err(format!(
                "there are no lessons in {}: each lies in a folder of its own whose name begins with a digit, as a file lesson.md",
                folder.display()
            ));
        }
        let name = folder.join("glossary.md").display().to_string();
        let mut course = Course::read(&texts, Some((&name, &glossary_text(folder))));
        course.beside = program_ids();
        Ok(Self { course, shelf: LessonShelf { folders: folders_of(folder, &texts) }, chosen: None })
    }
}

/// A folder's own glossary, or that of the program.
fn glossary_text(folder: &Path) -> String {
    let own = fs::read_to_string(folder.join("glossary.md")).ok();
    let of_program = || EMBEDDED.get_file("glossary.md").and_then(include_dir::File::contents_utf8).unwrap_or("");
    own.unwrap_or_else(|| of_program().to_owned())
}

/// The names of the lessons that come with the program.
fn program_ids() -> BTreeSet<String> {
    Course::embedded().lessons.into_iter().map(|lesson| lesson.id).collect()
}

fn folders_of(folder: &Path, texts: &[LessonText]) -> BTreeMap<String, PathBuf> {
    texts.iter().map(|text| (text.id.clone(), folder.join(&text.id))).collect()
}

/// The texts of the numbered folders in a folder.
fn disk_texts(folder: &Path) -> Result<Vec<LessonText>, String> {
    let entries = fs::read_dir(folder).map_err(|error| cannot(folder, &error))?;
    let mut texts = Vec::new();
    for entry in entries {
        let path = entry.map_err(|error| cannot(folder, &error))?.path();
        let id = id_of(&path);
        let is_numbered = id.starts_with(|c: char| c.is_ascii_digit());
        if is_numbered && path.join("lesson.md").is_file() {
            texts.push(text_of(&path, &id)?);
        }
    }
    texts.sort_by(|a, b| a.id.cmp(&b.id));
    Ok(texts)
}

fn id_of(folder: &Path) -> String {
    folder.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}

fn text_of(folder: &Path, id: &str) -> Result<LessonText, String> {
    let file = folder.join("lesson.md");
    let text = fs::read_to_string(&file).map_err(|error| cannot(&file, &error))?;
    Ok(LessonText { id: id.to_owned(), file: file.display().to_string(), text })
}

fn cannot(path: &Path, error: &std::io::Error) -> String {
    format!("cannot read {}: {error}", path.display())
}

impl LessonShelf {
    /// The file of a lesson that was read from disk.
    #[must_use]
    pub fn file(&self, lesson: &str) -> Option<PathBuf> {
        self.folders.get(lesson).map(|folder| folder.join("lesson.md"))
    }
}

impl Shelf for LessonShelf {
    fn text(&self, lesson: &str, file: &str) -> Option<String> {
        // A scene lies beside its lesson, not elsewhere on the disk.
        let is_plain = !file.contains("..") && !file.starts_with(['/', '\\']) && !file.contains(':');
        match self.folders.get(lesson) {
            Some(folder) if is_plain => fs::read_to_string(folder.join(file)).ok(),
            Some(_) => None,
            None => EMBEDDED.get_file(format!("{lesson}/{file}"))?.contents_utf8().map(str::to_owned),
        }
    }

    fn pictures<'a>(&'a self, lesson: &str) -> Box<dyn Files + 'a> {
        match self.folders.get(lesson) {
            Some(folder) => files_of_scene(&folder.join("lesson.md").display().to_string(), Outside::Refused),
            None => Box::new(Embedded { lesson: lesson.to_owned() }),
        }
    }
}

/// Pictures beside a lesson that comes with the program; where there are none, those of the scenes.
struct Embedded {
    lesson: String,
}

impl Files for Embedded {
    fn read(&self, path: &str) -> Result<Cow<'static, [u8]>, String> {
        match EMBEDDED.get_file(format!("{}/{path}", self.lesson)) {
            Some(file) => Ok(Cow::Borrowed(file.contents())),
            None => EmbeddedFiles::of_scene("textures/").read(path),
        }
    }
}

//! Where readers find the workbench: the program that they have, or its pages on the web, and then within the book, too.

use crate::view::escaped;

/// Where the workbench is.
#[derive(Clone, Debug, Default)]
pub struct Workbench {
    /// The folder of its pages, as seen from the root of the book or in full; none where only the program is there.
    folder: Option<String>,
}

impl Workbench {
    /// In a folder of pages, which `--workbench` names; without one, the program that opens `rayscope:` links.
    pub fn at(folder: Option<&str>) -> Self {
        let folder = folder.map(|folder| if folder.ends_with('/') { folder.to_owned() } else { format!("{folder}/") });
        Self { folder }
    }

    /// What opens a link, on a page from which `root` leads to the root of the book.
    pub fn address(&self, root: &str, link: &str) -> String {
        self.page(root).map_or_else(|| link.to_owned(), |page| format!("{page}#{link}"))
    }

    /// What is seen behind a link, alive, once it is unfolded. No script is needed: a frame that is folded away is not loaded.
    pub fn live(&self, root: &str, link: &str, title: &str) -> Option<String> {
        let source = format!("{}?embed=view#{link}", self.page(root)?);
        Some(format!(
            "<details class=\"live\"><summary>Step through it here</summary>\n\
             <iframe title=\"{}\" loading=\"lazy\" src=\"{}\"></iframe></details>\n",
            escaped(title),
            escaped(&source)
        ))
    }

    fn page(&self, root: &str) -> Option<String> {
        let folder = self.folder.as_ref()?;
        let is_whole = folder.starts_with('/') || folder.contains("://");
        Some(format!("{}{folder}index.html", if is_whole { "" } else { root }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINK: &str = "rayscope:csg/bowl?pixel=333,150";

    #[test]
    fn without_pages_links_are_for_the_program_and_nothing_is_alive() {
        let none = Workbench::at(None);
        assert_eq!(none.address("../", LINK), LINK);
        assert_eq!(none.live("../", LINK, "a step"), None);
    }

    #[test]
    fn a_folder_beside_the_book_is_found_from_every_page_and_one_elsewhere_as_it_is() {
        let beside = Workbench::at(Some(".."));
        assert_eq!(beside.address("../", LINK), format!("../../index.html#{LINK}"));
        assert_eq!(beside.address("", LINK), format!("../index.html#{LINK}"));
        let elsewhere = Workbench::at(Some("https://example.org/rayscope/"));
        assert_eq!(elsewhere.address("../", LINK), format!("https://example.org/rayscope/index.html#{LINK}"));
    }

    #[test]
    fn what_is_alive_waits_until_it_is_unfolded() {
        let live = Workbench::at(Some("../")).live("", "rayscope:a?pixel=1,2&event=3", "a \"step\"").unwrap();
        assert!(
            live.contains("loading=\"lazy\" src=\"../index.html?embed=view#rayscope:a?pixel=1,2&amp;event=3\""),
            "{live}"
        );
        assert!(live.starts_with("<details ") && live.contains("title=\"a &quot;step&quot;\""), "{live}");
    }
}

//! Where in the chapters something is taught.

/// A page of the built-in chapters, identified by names that do not change when pages are inserted
/// before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Passage {
    /// The id of the chapter.
    pub chapter: &'static str,
    /// The title of the page.
    pub page: &'static str,
}

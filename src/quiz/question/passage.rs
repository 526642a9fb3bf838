//! The place in the chapters where something is taught.

/// A page of the built-in chapters, identified by names that do not change when pages are inserted
/// before this page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Passage {
    /// The id of the chapter.
    pub chapter: &'static str,
    /// The title of the page.
    pub page: &'static str,
}

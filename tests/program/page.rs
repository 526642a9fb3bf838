//! `carrom page` writes a copy of the page with a teacher's own files in it.

use std::fs;
use std::io::Read;

use scraper::{Html, Selector};
use zip::ZipArchive;

use crate::folder::Folder;
use crate::start::{done, done_with, refused};

/// The parts of a page that matter here: the element for a teacher's files, and the text around it.
const PAGE: &str = "<!doctype html><title>carrom</title><p>before</p>\
    <script type=\"application/json\" id=\"own\">[]</script><p>after</p>";

/// The paths and texts of the teacher's files in a page, as a browser reads them.
fn own(folder: &Folder, name: &str) -> Vec<(String, String)> {
    let page = Html::parse_document(&fs::read_to_string(folder.path().join(name)).unwrap());
    let texts = |selector| -> Vec<String> {
        let selector = Selector::parse(selector).unwrap();
        page.select(&selector)
            .map(|it| it.text().collect())
            .collect()
    };
    assert_eq!(
        texts("p"),
        ["before", "after"],
        "the rest of the page is unchanged"
    );
    serde_json::from_str(&texts("#own").concat()).unwrap()
}

#[test]
fn a_page_contains_all_files_of_a_teacher() {
    let folder = Folder::new("page");
    folder.file("carrom.html", PAGE);
    done(&folder, "examples --out mine");
    let printed = done(
        &folder,
        "page --page carrom.html --levels mine/levels --lessons mine/chapters \
         --concepts mine/questions --out our-class.html",
    );
    assert_eq!(printed, "our-class.html\n");
    let own = own(&folder, "our-class.html");
    for (place, inside) in [
        ("levels/", "mine/levels"),
        ("lessons/", "mine/chapters"),
        ("concepts/", "mine/questions"),
    ] {
        let (path, text) = own
            .iter()
            .find(|(path, _)| path.starts_with(place))
            .unwrap();
        let name = path.rsplit('/').next().unwrap();
        let written = walk(&folder.path().join(inside), name);
        assert_eq!(text, &written, "{path}");
    }
}

/// The text of the file with this name in a folder or in its subfolders.
fn walk(folder: &std::path::Path, name: &str) -> String {
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.ends_with(name) {
                return fs::read_to_string(path).unwrap();
            }
        }
    }
    panic!("no {name}");
}

#[test]
fn a_page_is_made_only_from_a_carrom_page_and_overwrites_nothing() {
    let folder = Folder::new("no-page");
    folder.file("carrom.html", PAGE);
    folder.file("other.html", "<!doctype html><title>other</title>");
    let message = refused(&folder, "page --page other.html --out our.html", 2);
    assert!(message.contains("this is not a carrom page"), "{message}");
    let message = refused(&folder, "page --page none.html --out our.html", 2);
    assert!(message.contains("cannot read none.html"), "{message}");
    done(&folder, "page --page carrom.html --out our.html");
    let message = refused(&folder, "page --page carrom.html --out our.html", 1);
    assert!(message.contains("--force replaces it"), "{message}");
    done(&folder, "page --page carrom.html --out our.html --force");
    // An invalid file is refused here too, with its line.
    fs::create_dir(folder.path().join("levels")).unwrap();
    folder.file("levels/bad.toml", "format = 1\ntitle = 7\n");
    let message = refused(
        &folder,
        "page --page carrom.html --levels levels --out bad.html",
        2,
    );
    assert!(message.contains("bad.toml"), "{message}");
    assert!(!folder.path().join("bad.html").exists());
}

#[test]
fn a_scorm_package_contains_a_manifest_and_the_page_with_its_round() {
    let folder = Folder::new("scorm");
    folder.file("carrom.html", PAGE);
    let arguments = "page --page carrom.html --scorm quick-7 --out";
    let printed = done(&folder, &format!("{arguments} a.zip"));
    assert_eq!(printed, "a.zip\n");
    let path = folder.path().join("a.zip");
    let mut package = ZipArchive::new(fs::File::open(&path).unwrap()).unwrap();
    let mut text = |name: &str| {
        let mut text = String::new();
        let mut file = package.by_name(name).unwrap();
        file.read_to_string(&mut text).unwrap();
        text
    };
    let manifest = text("imsmanifest.xml");
    folder.file("index.html", text("index.html"));
    let own = own(&folder, "index.html");
    assert_eq!(own, [("scorm/round".to_owned(), "quick-7".to_owned())]);
    let manifest = roxmltree::Document::parse(&manifest).unwrap();
    let named = |name: &str| {
        let mut all = manifest.descendants();
        all.find(|it| it.tag_name().name() == name).unwrap()
    };
    assert_eq!(named("schemaversion").text(), Some("1.2"));
    // Each reference in the manifest matches its target.
    let [organizations, organization, item, resource, file] =
        ["organizations", "organization", "item", "resource", "file"].map(named);
    assert_eq!(
        organizations.attribute("default"),
        organization.attribute("identifier")
    );
    assert_eq!(
        item.attribute("identifierref"),
        resource.attribute("identifier")
    );
    assert_eq!(resource.attribute("href"), file.attribute("href"));
    assert_eq!(file.attribute("href"), Some("index.html"));
    let adl = "http://www.adlnet.org/xsd/adlcp_rootv1p2";
    assert_eq!(resource.attribute((adl, "scormtype")), Some("sco"));
    // The same round gives the same package.
    done(&folder, &format!("{arguments} b.zip"));
    assert_eq!(
        fs::read(path).unwrap(),
        fs::read(folder.path().join("b.zip")).unwrap()
    );
    // Only a round that is the same for everyone can be given to everyone.
    for (code, reason) in [
        ("find-out-7", "depend on the answers"),
        ("own-7", "--concepts"),
        ("quick", "code"),
    ] {
        let message = refused(
            &folder,
            &format!("page --page carrom.html --scorm {code} --out c.zip"),
            2,
        );
        assert!(message.contains(reason), "{message}");
    }
}

/// The screen for teachers writes, without a command line, the same files as the commands.
#[test]
fn the_screen_for_teachers_writes_the_same_page_and_package() {
    let folder = Folder::new("teacher-page");
    folder.file("carrom.html", PAGE);
    done(&folder, "examples --out mine");
    let from = "--page carrom.html --concepts mine/questions";
    done(&folder, &format!("page {from} --out by-command.html"));
    let scorm = format!("page {from} --scorm speeds-3 --out by-command.zip");
    done(&folder, &scorm);
    let lines = "choose carrom as one file for browsers\n\
                 choose round for a learning platform\n\
                 code = speeds-3\n\
                 choose write it\n";
    let screen = format!("teacher {from} --plain --data-dir data");
    let said = done_with(&folder, &screen, lines);
    // The page that the program started from is not overwritten.
    for [name, by_command] in [
        ["carrom-2.html", "by-command.html"],
        ["scorm-speeds-3.zip", "by-command.zip"],
    ] {
        assert!(said.contains(name), "{said}");
        let [written, expected] =
            [name, by_command].map(|name| fs::read(folder.path().join(name)).unwrap());
        assert!(written == expected, "{name}: {said}");
    }
}

/// An error in the teacher's files is reported, and carrom does not write a page without these
/// files.
#[test]
fn the_screen_for_teachers_writes_no_page_with_errors_in_its_files() {
    let folder = Folder::new("teacher-bad-page");
    folder.file("carrom.html", PAGE);
    fs::create_dir(folder.path().join("questions")).unwrap();
    folder.file("questions/bad.toml", "format = 1\ntitle = 7\n");
    let screen = "teacher --page carrom.html --concepts questions --plain --data-dir data";
    let said = done_with(&folder, screen, "choose carrom as one file for browsers\n");
    assert!(said.contains("Nothing could be written"), "{said}");
    assert!(said.contains("bad.toml"), "{said}");
    assert!(!folder.path().join("carrom-2.html").exists());
}

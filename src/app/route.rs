//! The names of routes, as used on the command line and in links.

use super::Data;
use crate::game::{BoardCode, Rules};
use crate::physics::CollisionSpec;
use crate::quiz::{Answer, Code};
use crate::screens::{Context, FoilPage, Route};

impl Data {
    /// The route with this name. `value` specifies what the screen shows, such as a chapter, a
    /// level or the code of a round, and may be empty.
    ///
    /// # Errors
    /// Returns a description of what was expected instead.
    pub fn route(&self, name: &str, value: &str) -> Result<Route, String> {
        Ok(match name {
            "home" => Route::Home,
            "learn" | "lesson" if value.is_empty() => Route::Learn,
            "learn" | "lesson" => {
                let expected =
                    "the number or the name of a chapter, such as 2 or the-line-of-impact";
                let (name, page) = value.split_once(':').unwrap_or((value, ""));
                let chapter = self.book.library().find(name).ok_or(expected)?;
                let pages = self.book.chapter(chapter).map_or(0, |it| it.pages.len());
                let page = match page.parse() {
                    _ if page.is_empty() => return Ok(Route::Chapter(chapter)),
                    Ok(page) if (1..=pages).contains(&page) => page - 1,
                    _ => return Err(format!("a page of that chapter, 1 to {pages}")),
                };
                Route::Page { chapter, page }
            }
            "lab" if value.is_empty() => Route::Lab,
            "lab" => {
                let shown = value.strip_suffix(HIDE).map(|it| it.trim_end_matches(','));
                Route::LabOf {
                    setup: CollisionSpec::from_link(shown.unwrap_or(value))?,
                    hidden: shown.is_some(),
                }
            }
            "foil" if value.is_empty() => Route::Foil(FoilPage::default()),
            "foil" => {
                let number = value.parse::<usize>().ok();
                let page = number.and_then(|page| FoilPage::ALL.get(page.checked_sub(1)?));
                Route::Foil(*page.ok_or("a page of the foil, 1 to 3")?)
            }
            "glossary" => Route::Glossary,
            "table" => Route::Table,
            "board" if value.is_empty() => Route::Board(None),
            "board" => Route::Board(Some(BoardCode::parse(value).map_err(|_| BOARD)?)),
            "rules" => {
                let is_meant = |rules: &Rules| rules_in_link(*rules) == value || value.is_empty();
                let rules = Rules::ALL.into_iter().find(is_meant);
                Route::Rules(rules.ok_or("tournament, friendly, points, practice or board")?)
            }
            "quiz" => Route::Quiz(self.round(value)?),
            "class" => Route::Class {
                code: self.round(value)?,
                teams: Vec::new(),
                name: String::new(),
            },
            "join" => Route::Join {
                address: None,
                code: None,
                again: false,
            },
            "levels" | "level" if value.is_empty() => Route::Levels,
            "levels" | "level" => {
                let number = self.shelf.find(value);
                Route::Level(number.ok_or("the id of a level, such as dead-stop")?)
            }
            "progress" => Route::Progress,
            "teacher" => Route::Teacher,
            "settings" => Route::Settings,
            _ => return Err("a screen, such as quiz".into()),
        })
    }

    /// The round described by a code, with the teacher's own questions if the code refers to them;
    /// `None` if the code is empty.
    fn round(&self, code: &str) -> Result<Option<Code>, String> {
        if code.is_empty() {
            return Ok(None);
        }
        let code = Code::parse(code).ok_or("the code of a round, such as mixed-7")?;
        code.with_own(&self.own).map(Some)
    }
}

/// The suffix of a link to a hit in the lab whose outcome is hidden.
const HIDE: &str = "hide";

/// The rules in a link: the first word of their name.
fn rules_in_link(rules: Rules) -> &'static str {
    let name: &str = rules.into();
    name.split(' ').next().unwrap_or(name)
}

/// How a message describes the code of a board for one player.
const BOARD: &str = "the code of a board: a day such as 2026-11-26, or a number up to 999999";

/// The separator between the address of a round and the answers given in the round.
const ANSWERS: &str = "&said=";

/// The address of a route, for most routes in the form that [`Data::route`] reads. The answers
/// given in a round come after [`ANSWERS`].
pub(super) fn address(route: &Route, cx: &Context) -> String {
    let name: &str = route.into();
    let named = |value: &str| match value {
        "" => name.to_owned(),
        value => format!("{name}={value}"),
    };
    let round = |code: &Code| match code.course.kind.is_personal() {
        // The questions depend on the player's record, so the code would be of no use to anybody
        // else.
        true => name.to_owned(),
        false => named(&code.to_string()),
    };
    let chapter = |at: usize| cx.book.chapter(at).map_or("", |it| &it.id);
    match route {
        // The file of a measured collision is not part of a link.
        Route::Home | Route::Measured(_) => String::new(),
        Route::LabOf { setup, hidden } => {
            let hide = hidden.then(|| HIDE.to_owned());
            let parts = [Some(setup.to_link()).filter(|it| !it.is_empty()), hide];
            let parts: Vec<_> = parts.into_iter().flatten().collect();
            named(&parts.join(","))
        }
        Route::Chapter(at) => named(chapter(*at)),
        Route::Page { chapter: at, page } => named(&format!("{}:{}", chapter(*at), page + 1)),
        Route::OpenRound {
            code,
            answers,
            is_explained,
        } => {
            let address = round(code);
            if answers.is_empty() || code.course.kind.is_personal() {
                return address;
            }
            let answers: Vec<_> = answers.iter().map(|it| it.to_text()).collect();
            let said = answers.join(";").replace(' ', "+");
            let explained = if *is_explained { ";" } else { "" };
            format!("{address}{ANSWERS}{said}{explained}")
        }
        Route::Quiz(code) | Route::Class { code, .. } | Route::Host { code, .. } => {
            code.as_ref().map_or(name.to_owned(), round)
        }
        Route::Join {
            code: Some(code), ..
        } => format!("code={code}"),
        Route::Foil(page) if *page != FoilPage::default() => {
            named(&(*page as usize + 1).to_string())
        }
        Route::Board(Some(code)) => named(&code.to_string()),
        Route::Rules(rules) => named(rules_in_link(*rules)),
        Route::Level(number) => match cx.shelf.get(*number) {
            Some((pack, level)) => named(&format!("{}/{}", pack.name, level.id)),
            None => "levels".into(),
        },
        _ => name.to_owned(),
    }
}

impl Route {
    /// The round with the answers that are in its address.
    ///
    /// # Errors
    /// Returns a description of what was expected instead.
    pub fn with_answers(self, said: &str) -> Result<Self, String> {
        let Self::Quiz(Some(code)) = self else {
            return Err("answers only after the code of a round".into());
        };
        let is_explained = said.ends_with(';');
        let said = said.split(';').filter(|said| !said.is_empty());
        let answers: Option<_> = said.map(Answer::parse).collect();
        Ok(Self::OpenRound {
            code,
            answers: answers.ok_or("answers such as choice 2 sure")?,
            is_explained,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::App;
    use crate::messages::{Input, Key};
    use crate::screens::Settings;

    fn opened(route: Route) -> App {
        App::new(route, Settings::default(), 1)
    }

    /// The app that opens for a link with this address.
    fn linked(address: &str) -> App {
        let (address, said) = address.split_once(ANSWERS).unwrap_or((address, ""));
        let (name, value) = address.split_once('=').unwrap_or((address, ""));
        let route = Data::default().route(name, value).expect(address);
        opened(match said {
            "" => route,
            said => route.with_answers(&said.replace('+', " ")).expect(said),
        })
    }

    #[test]
    fn every_screen_can_be_reopened_by_its_address() {
        for address in [
            "home",
            "lab",
            "lab=m2:5.5,b:12,e:0.8",
            "lab=m2:5.5,b:12,e:0.8,hide",
            "lab=hide",
            "learn",
            "lesson=the-line-of-impact",
            "lesson=the-line-of-impact:3",
            "glossary",
            "quiz",
            "quiz=mixed-7",
            "class",
            "join",
            "foil",
            "foil=2",
            "table",
            "board",
            "board=2026-11-26",
            "board=4711",
            "rules=friendly",
            "levels",
            "level=first-hits/dead-stop",
            "progress",
            "settings",
        ] {
            let (found, depth) = linked(address).address();
            let expected = if address == "home" { "" } else { address };
            assert_eq!(found, expected);
            assert!((1..=3).contains(&depth), "{address}: {depth}");
        }
    }

    /// A round continues at the same question with the same answers, even if the next question
    /// depends on these answers.
    #[test]
    fn a_round_continues_where_the_player_left_off() {
        for code in ["mixed-7", "find-out-3", "exam-4", "hits-2"] {
            let mut app = linked(&format!("quiz={code}"));
            app.update(&Input::Resize(120, 40));
            'round: for _ in 0..12 {
                for key in [Key::Char('1'), Key::Enter, Key::Enter] {
                    app.update(&Input::Key(key));
                    if app
                        .stack
                        .last()
                        .is_some_and(|it| it.status(&app.context).contains("answered"))
                    {
                        break 'round;
                    }
                    let (address, _) = app.address();
                    let again = linked(&address);
                    assert_eq!(again.address().0, address);
                    // The points for an answer are shown after the collision has been replayed.
                    let status = |app: &App| {
                        let top = app.stack.last().expect("a screen");
                        let status = top.status(&app.context);
                        status.split("  ").next().map(str::to_owned)
                    };
                    assert_eq!(status(&again), status(&app), "{address}");
                }
            }
            assert!(app.address().0.contains(ANSWERS), "{code}");
        }
    }

    #[test]
    fn a_page_that_a_chapter_does_not_have_is_refused() {
        for value in ["2:0", "2:99", "2:-1", "2:x"] {
            let refused = Data::default().route("lesson", value);
            let message = refused.expect_err(value);
            assert!(
                message.starts_with("a page of that chapter, 1 to "),
                "{message}"
            );
        }
    }

    #[test]
    fn answers_that_do_not_fit_are_ignored() {
        let address = "quiz=mixed-7&said=choice+99+sure;choice+1+sure";
        assert_eq!(linked(address).address().0, "quiz=mixed-7");
        let round = || Data::default().route("quiz", "mixed-7").expect("a round");
        assert!(round().with_answers("rays nan still sure").is_err());
        assert!(Route::Lab.with_answers("choice 1 sure").is_err());
    }
}

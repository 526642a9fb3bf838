//! A class round without a screen: votes, scores, the saved file and the exported tables.

use std::sync::Arc;

use carrom::class::{
    ClassChange, ClassRound, JoinCode, SeatToken, Vote, answers_csv, appended, items, items_csv,
    standings, team_names,
};
use carrom::quiz::{Code, Form, Response};

fn round(code: &str, teams: &[&str]) -> ClassRound {
    let names = team_names(teams.iter().copied()).unwrap();
    ClassRound::new(Code::parse(code).unwrap(), names)
}

/// Three teams: one is always right, one first follows a misconception and is right after the
/// discussion, and one always follows the misconception.
fn played() -> ClassRound {
    let mut round = round("mixed-7", &["Ants", "=Bees", "Cats, \"C\""]);
    for i in 0..round.questions().len() {
        let question = &round.questions()[i];
        let truth = question.form.truth();
        let held = question.beliefs[0].said;
        for (team, first, second) in [(0, truth, None), (1, held, Some(truth)), (2, held, None)] {
            round.vote(i, team, Vote::First, Some(first));
            round.vote(i, team, Vote::Second, second);
        }
    }
    round
}

#[test]
fn the_second_vote_scores_and_the_first_is_kept() {
    let round = played();
    let asked = round.questions().len();
    let board = standings(&round, asked);
    let places: Vec<_> = board.iter().map(|it| (it.team, it.place)).collect();
    assert_eq!(places, [(0, 1), (1, 1), (2, 3)]);
    assert!((board[0].points - 10.0 * asked as f64).abs() < 1e-9);
    assert!((board[1].gain - 10.0).abs() < 1e-9 && board[2].points < board[0].points);
    for item in items(&round, asked) {
        let [first, second] = item.votes.map(|it| it.share_right().unwrap());
        assert!((first - 1.0 / 3.0).abs() < 1e-12 && (second - 2.0 / 3.0).abs() < 1e-12);
        let held = round.questions()[item.question].beliefs[0].misconception;
        assert_eq!(item.commonest, Some((held, 2)));
        // One of the two teams that were wrong changed to the right answer.
        assert!((item.gain.unwrap() - 0.5).abs() < 1e-12);
        assert_eq!(item.changed, Some([1, 0]));
        let all = item.counts.iter().map(|(_, counts)| *counts);
        let sum = all.fold([0, 0], |sum, it| [sum[0] + it[0], sum[1] + it[1]]);
        assert_eq!(sum, [3, 3]);
        // Three teams are too few for a discrimination index.
        assert_eq!(item.discrimination, None);
    }
}

/// Ten people on devices, half of them always right: every question discriminates equally. Ten is
/// the smallest number for which the index is calculated.
#[test]
fn ten_people_are_enough_for_a_discrimination_index() {
    let devices = |people: usize| {
        let mut round = ClassRound::with_devices(Code::parse("mixed-7").unwrap());
        round.open(JoinCode::of(7), None);
        for person in 0..people {
            let seat = SeatToken::of(person as u128 + 1);
            let name = format!("Person {person}");
            round
                .change(&ClassChange::Join {
                    seat: Some(seat),
                    name,
                })
                .unwrap();
            for i in 0..round.questions().len() {
                let form = &round.questions()[i].form;
                let held = round.questions()[i].beliefs[0].said;
                let said = if person % 2 == 0 { form.truth() } else { held };
                round.vote(i, person, Vote::First, Some(said));
            }
        }
        items(&round, round.questions().len())
    };
    assert!(devices(9).iter().all(|it| it.discrimination.is_none()));
    for item in devices(10) {
        assert!(item.discrimination.unwrap() > 0.99);
        assert_eq!(item.gain, Some(0.0));
    }
}

#[test]
fn a_saved_round_is_resumed() {
    let round = played();
    let text = round.text().unwrap();
    let again = ClassRound::read("round", text.as_bytes(), &Arc::default()).unwrap();
    assert_eq!(again.teams(), round.teams());
    assert_eq!(again.code(), round.code());
    for i in 0..round.questions().len() {
        for team in 0..3 {
            for vote in [Vote::First, Vote::Second] {
                let [old, new] = [&round, &again].map(|it| it.ballot(i, team).vote(vote));
                let form = &round.questions()[i].form;
                assert_eq!(old.is_some(), new.is_some());
                if let (Some(old), Some(new)) = (old, new) {
                    assert!(form.distance(&old, &new) < 1e-9);
                }
            }
        }
    }
    assert_eq!(again.begun(), round.questions().len());
}

/// The name of the class is saved, and is at the end of each row of both tables.
#[test]
fn the_name_of_the_class_is_in_its_file_and_its_tables() {
    let named = played().of_class(" 10b\u{202e} \"x\" ");
    assert_eq!(named.class(), "10b \"x\"");
    let text = named.text().unwrap();
    let again = ClassRound::read("round", text.as_bytes(), &Arc::default()).unwrap();
    assert_eq!(again.class(), named.class());
    for (round, name) in [(named, "10b \"x\""), (played(), "")] {
        for table in [answers_csv(&round, ""), items_csv(&round, "")] {
            let table = table.unwrap();
            let mut reader = csv::Reader::from_reader(table.as_bytes());
            let heads = reader.headers().unwrap().clone();
            assert_eq!(heads.iter().next_back(), Some("class"));
            let mut rows = reader.records().map(Result::unwrap);
            assert!(
                rows.all(|row| row.iter().next_back() == Some(name)),
                "{table}"
            );
        }
    }
    let bad = text.replace("class = ", "class = \"\u{7}\" # ");
    let told = ClassRound::read("round", bad.as_bytes(), &Arc::default()).unwrap_err();
    assert!(told.to_string().contains("class: "), "{told}");
}

#[test]
fn a_file_of_the_first_format_still_opens() {
    let text = "format = 1\ncode = \"7\"\nteams = [\"Ants\", \"Bees\"]\n\n\
                [[question]]\nfirst = [\"rays 60 30\", \"rays still 0\"]\nsecond = [\"\", \"rays 45 45\"]\n";
    let round = ClassRound::read("old", text.as_bytes(), &Arc::default()).unwrap();
    assert_eq!(
        (
            round.begun(),
            round.voted(0, Vote::First),
            round.voted(0, Vote::Second)
        ),
        (1, 2, 1)
    );
}

#[test]
fn a_bad_file_gives_a_message() {
    let good = "format = 1\ncode = \"7\"\nteams = [\"Ants\"]\n";
    for (text, complaint) in [
        (String::new(), "format"),
        ("format = 7\n".into(), "newer"),
        ("format = \"x\"\n".into(), "format"),
        (good.replace("\"7\"", "\"seven\""), "code"),
        (good.replace("\"Ants\"", "\"Ants\", \"ants\""), "twice"),
        (good.replace("\"Ants\"", "\" Ants\""), "visible"),
        (good.replace("[\"Ants\"]", "[]"), "found none"),
        (format!("{good}extra = 1\n"), "extra"),
        (
            format!("{good}door = \"BCDFGH\"\naddress = \"here\"\nseats = [\"\"]\n"),
            "address",
        ),
        (
            format!("{good}[[question]]\nfirst = [\"\", \"rays 1 2\"]\nsecond = []\n"),
            "found more",
        ),
    ] {
        let fault = ClassRound::read("bad", text.as_bytes(), &Arc::default())
            .unwrap_err()
            .to_string();
        assert!(fault.contains(complaint), "{complaint}: {fault}\n{text}");
        assert!(fault.starts_with("bad"), "{fault}");
    }
    let noise: Vec<u8> = (0..10_000_000_u64)
        .map(|i| (i * 7919 % 251) as u8)
        .collect();
    assert!(ClassRound::read("noise", &noise, &Arc::default()).is_err());
}

/// An impossible vote once prevented the whole round from opening, or made carrom crash when the
/// round was shown.
#[test]
fn an_impossible_vote_is_dropped_and_its_round_still_opens() {
    let questions = [
        "first = [\"choice 1\", \"choice 99\"]\nsecond = [\"\", \"choice 18446744073709551615\"]",
        "first = [\"number 3\", \"rays NaN 3\"]\nsecond = []",
    ];
    let votes = [
        "vote 1 first 2 choice 98",
        "vote 1 first 2 rays inf 3",
        "vote 99 first 1 choice 1",
        "vote 1 first 99 choice 1",
        "vote 1 third 1 choice 1",
        "vote 3 first 2 sure choice 2",
    ];
    let text = format!(
        "format = 3\ncode = \"concept-1\"\nway = \"devices\"\nteams = [\"Ada\", \"Bo\"]\n\n\
         [[question]]\n{}\n\n[[question]]\n{}\n\n[[then]]\nchanges = {votes:?}\n",
        questions[0], questions[1],
    );
    let round = ClassRound::read("poisoned", text.as_bytes(), &Arc::default()).unwrap();
    assert_eq!(round.dropped_votes(), 9);
    let voted = [0, 1, 2].map(|question| round.voted(question, Vote::First));
    assert_eq!(voted, [1, 0, 1]);
    assert_eq!(
        round.ballot(2, 1).vote(Vote::First),
        Some(Response::Choice(1))
    );
    // The file that is written next contains no impossible votes.
    let text = round.text().unwrap();
    let again = ClassRound::read("again", text.as_bytes(), &Arc::default()).unwrap();
    assert_eq!(again.dropped_votes(), 0);
    // Other impossible changes are still errors.
    let with = |line: &str| {
        let text = format!("{text}[[then]]\nchange = '{line}'\n");
        ClassRound::read("bad", text.as_bytes(), &Arc::default())
    };
    for line in [r#"{"remove":{"person":8}}"#, "x", "remove 1", "{}", ""] {
        assert!(with(line).is_err(), "{line}");
    }
    for vote in [
        r#""question":0,"vote":"first","person":1,"said":"choice 98""#,
        r#""question":0,"vote":"first","person":1,"said":"rays inf 3""#,
        r#""question":98,"vote":"first","person":0,"said":"choice 1""#,
        r#""question":0,"vote":"third","person":0,"said":"choice 1""#,
    ] {
        let round = with(&format!("{{\"vote\":{{{vote}}}}}")).unwrap();
        assert_eq!(round.dropped_votes(), 1, "{vote}");
    }
}

/// The line that was appended last may be incomplete.
#[test]
fn a_round_that_was_being_written_opens_without_its_last_line() {
    let mut round = ClassRound::with_devices(Code::parse("concept-1").unwrap());
    round.open(JoinCode::of(7), None);
    for (seat, name) in [(1, "Ada"), (2, "Bo")] {
        let seat = Some(SeatToken::of(seat));
        let name = name.to_owned();
        round.change(&ClassChange::Join { seat, name }).unwrap();
    }
    round.change(&ClassChange::Remove { person: 0 }).unwrap();
    let text = round.text().unwrap();
    let again = ClassRound::read("again", text.as_bytes(), &Arc::default()).unwrap();
    assert_eq!(again, round);
    let vote = ClassChange::Vote {
        question: 0,
        vote: Vote::First,
        person: 0,
        said: Some(Response::Choice(1).into()),
    };
    let added = appended(&[vote.clone(), vote]).unwrap();
    for end in 0..=added.len() {
        let text = format!("{text}{}", &added[..end]);
        let read = ClassRound::read("cut", text.as_bytes(), &Arc::default());
        assert_eq!(read.unwrap().teams(), ["Bo"], "{text}");
    }
    let whole = format!("{text}{added}");
    let read = ClassRound::read("whole", whole.as_bytes(), &Arc::default()).unwrap();
    assert_eq!(read.voted(0, Vote::First), 1);
}

/// A file stores a round as changes that lead to it, which need not be the changes that were made.
#[test]
fn a_round_with_any_history_is_read_back_as_it_was_written() {
    let names = ["Ada", "ada", "Bo", "Bo 2", "Zo\u{eb}", "'\"\\", "=1+1"];
    let mut state = 7_u64;
    let mut below = |most: usize| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 33) as usize % most
    };
    let mut done = 0;
    for _ in 0..40 {
        let mut round = ClassRound::with_devices(Code::parse("mixed3-7").unwrap());
        round.open(JoinCode::of(7), None);
        for seat in 0..60 {
            let person = below(6);
            let name = names[below(names.len())].to_owned();
            let change = match below(9) {
                0 | 1 => ClassChange::Join {
                    seat: (below(3) > 0).then(|| SeatToken::of(seat)),
                    name: round.name_for(&name).unwrap(),
                },
                2 => ClassChange::Rename { person, name },
                3 => ClassChange::Remove { person },
                4 => ClassChange::Readmit { removed: below(3) },
                5 => ClassChange::Vacate { person },
                6 => ClassChange::Merge {
                    from: person,
                    into: below(6),
                },
                _ => {
                    let question = below(3);
                    let truth = round.questions()[question].form.truth();
                    ClassChange::Vote {
                        question,
                        vote: Vote::BOTH[below(2)],
                        person,
                        said: (below(4) > 0).then(|| truth.into()),
                    }
                }
            };
            done += usize::from(round.change(&change).is_ok());
            let text = round.text().unwrap();
            let again = ClassRound::read("again", text.as_bytes(), &Arc::default());
            assert_eq!(again.as_ref(), Ok(&round), "{text}");
        }
    }
    assert!(done > 1000, "{done} changes");
}

/// Names without a visible letter were once allowed; files that contain them can still be opened,
/// and the people get other names.
#[test]
fn invisible_names_are_refused_but_files_that_contain_them_open() {
    for name in [
        "\u{2800}",
        "\u{3164}",
        "\u{115f}\u{1160}",
        "\u{ffa0}",
        "\u{180e}\u{200d}\u{fe0f}",
    ] {
        assert!(team_names([name]).is_err(), "{name:?}");
        let round = round("7", &["Ants"]);
        assert_eq!(round.name_for(name), None, "{name:?}");
        assert_eq!(round.renamed(0, name), None, "{name:?}");
    }
    let seats = [1, 2, 3].map(|seat| SeatToken::of(seat).to_string());
    let text = format!(
        "format = 3\ncode = \"7\"\nclass = \"\u{2800}\"\nway = \"devices\"\n\
         teams = [\"\u{2800}\", \"\u{3164}\"]\ndoor = \"{}\"\nseats = [\"{}\", \"{}\"]\n\n\
         [[then]]\nchanges = [\"join {} \u{ffa0}\", \"rename 1 \u{2800}\u{2800}\"]\n",
        JoinCode::of(7),
        seats[0],
        seats[1],
        seats[2],
    );
    let round = ClassRound::read("old", text.as_bytes(), &Arc::default()).unwrap();
    assert_eq!(round.class(), "");
    assert_eq!(round.teams(), ["No name 4", "No name 2", "No name 3"]);
}

#[test]
fn a_vote_of_another_kind_is_refused() {
    let mut round = round("7", &["Ants"]);
    assert!(matches!(round.questions()[0].form, Form::Rays { .. }));
    for said in [
        Response::Number(3.0),
        Response::Choice(0),
        Response::Shot(0.0),
    ] {
        round.vote(0, 0, Vote::First, Some(said));
        assert_eq!(round.ballot(0, 0).vote(Vote::First), None);
    }
    round.vote(99, 0, Vote::First, Some(Response::Number(1.0)));
    round.vote(0, 99, Vote::First, None);
    assert!(!round.is_begun());
}

/// Pupils on devices choose their names, and an edited file may contain any name.
#[test]
fn no_name_or_class_becomes_a_formula_in_a_class_table() {
    let hostile = [
        "=HYPERLINK(\"http://x\")",
        "=cmd|'/c calc'!A1",
        "@SUM(A1)",
        "+1+1",
        "-1-1",
        "a;=1+1",
        "＝1+1",
    ];
    for class in hostile {
        let mut round = round("mixed-7", &hostile).of_class(class);
        for team in 0..hostile.len() {
            let truth = round.questions()[0].form.truth();
            round.vote(0, team, Vote::First, Some(truth));
        }
        let rows = [answers_csv(&round, class), items_csv(&round, class)].map(|table| {
            let table = table.unwrap();
            let mut reader = csv::Reader::from_reader(table.as_bytes());
            reader.records().map(Result::unwrap).collect::<Vec<_>>()
        });
        assert!(rows[0].len() >= hostile.len());
        for cell in rows.iter().flatten().flatten() {
            let begins = |part: &str| part.trim_start().starts_with(['=', '+', '@', '-', '＝']);
            let is_formula = cell.split(';').any(begins) && cell.parse::<f64>().is_err();
            assert!(!is_formula, "{cell:?}");
        }
        assert_eq!(rows[0][0][6], format!("'{}", hostile[0]));
    }
}

#[test]
fn the_tables_can_be_read_back_and_contain_no_formula() {
    let round = played();
    let answers = answers_csv(&round, "2026-11-22").unwrap();
    let rows: Vec<csv::StringRecord> = csv::Reader::from_reader(answers.as_bytes())
        .records()
        .map(Result::unwrap)
        .collect();
    assert_eq!(rows.len(), 3 * round.questions().len());
    assert_eq!(&rows[1][6], "'=Bees");
    assert_eq!(&rows[2][6], "Cats, \"C\"");
    assert_eq!(&rows[0][8], "yes");
    assert_eq!(
        &rows[1][11],
        round.questions()[0].beliefs[0].misconception.id()
    );
    assert_eq!(&rows[1][13], "yes");
    let items = items_csv(&round, "2026-11-22").unwrap();
    let rows: Vec<csv::StringRecord> = csv::Reader::from_reader(items.as_bytes())
        .records()
        .map(Result::unwrap)
        .collect();
    assert_eq!(rows.len(), round.questions().len());
    assert_eq!((&rows[0][7], &rows[0][11]), ("0.333", "0.667"));
    for text in [
        &answers,
        &answers_csv(&self::round("7", &["A"]), "").unwrap(),
    ] {
        assert!(!text.contains("NaN") && !text.contains("inf"));
    }
}

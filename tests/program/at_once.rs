//! Tests that mostly wait: for the limits of a host, for devices, for a program in a terminal. One
//! after the other they would take more than 40 s, so they run at the same time. A failure names its test.
//! The name of this module puts them first, so that others can run while they wait.

use std::thread;

#[cfg(unix)]
use crate::terminal;
#[cfg(target_os = "linux")]
use crate::{crowd, idle, unsaved};
use crate::{hosted, worksheet};

const WAITS: &[(&str, fn())] = &[
    #[cfg(target_os = "linux")]
    (
        "a few devices vote alongside slow and hostile ones",
        crowd::a_few_devices_vote_alongside_slow_and_hostile_ones,
    ),
    #[cfg(target_os = "linux")]
    (
        "a host that is killed during a round loses no vote",
        crowd::a_host_that_is_killed_during_a_round_loses_no_vote,
    ),
    #[cfg(target_os = "linux")]
    (
        "guessing codes is slow over any number of connections",
        hosted::guessing_codes_is_slow_over_any_number_of_connections,
    ),
    #[cfg(target_os = "linux")]
    (
        "an idle program uses no processor time",
        idle::an_idle_program_uses_no_processor_time,
    ),
    #[cfg(target_os = "linux")]
    (
        "answers given while the disk is full are saved afterwards",
        unsaved::answers_given_while_the_disk_is_full_are_saved_afterwards,
    ),
    #[cfg(unix)]
    (
        "a key pressed while the window changes is not lost",
        terminal::a_key_pressed_while_the_window_changes_is_not_lost,
    ),
    (
        "printing on A4 splits no block and the key starts a page",
        worksheet::printing_on_a4_splits_no_block_and_the_key_starts_a_page,
    ),
    (
        "nobody gets in without the code",
        hosted::nobody_gets_in_without_the_code,
    ),
    (
        "a hand-in is on the disk before it is confirmed",
        hosted::a_hand_in_is_on_the_disk_before_it_is_confirmed,
    ),
    (
        "a round is resumed at the port where its devices look for it",
        hosted::a_round_is_resumed_at_the_port_where_its_devices_look_for_it,
    ),
];

#[test]
fn tests_that_mostly_wait() {
    thread::scope(|scope| {
        for (name, test) in WAITS {
            let thread = thread::Builder::new().name((*name).to_owned());
            thread.spawn_scoped(scope, test).unwrap();
        }
    });
}

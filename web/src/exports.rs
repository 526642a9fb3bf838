//! What the page calls by name, and the memory that both use.
//!
//! The page has one thread. It asks for room, writes what it says there and calls
//! [`carrom_call`]; what it is told in return lies where [`carrom_reply`] says until the
//! next call.

use std::cell::RefCell;

use crate::message::{self, Command};
use crate::shell::Shell;

/// What both sides share.
struct Shared {
    said: Vec<u8>,
    reply: Vec<u8>,
    cells: Vec<u32>,
    shell: Option<Shell>,
}

thread_local! {
    static SHARED: RefCell<Shared> = const {
        RefCell::new(Shared { said: Vec::new(), reply: Vec::new(), cells: Vec::new(), shell: None })
    };
}

/// Room for so many bytes that the page is to say.
#[unsafe(no_mangle)]
pub extern "C" fn carrom_room(bytes: usize) -> *mut u8 {
    SHARED.with_borrow_mut(|shared| {
        shared.said = vec![0; bytes];
        shared.said.as_mut_ptr()
    })
}

/// Carries out the page's command; returns the length of the reply.
#[unsafe(no_mangle)]
pub extern "C" fn carrom_call() -> usize {
    SHARED.with_borrow_mut(|shared| {
        let said = std::mem::take(&mut shared.said);
        shared.reply = match message::read(&said) {
            Ok((Command::Open(opening), bytes)) => {
                let (shell, reply) = match shared.shell.take() {
                    Some(before) => before.reopen(&opening, bytes),
                    None => Shell::open(&opening, bytes),
                };
                shared.shell = Some(shell);
                message::write(&reply)
            }
            Ok((command, bytes)) => match &mut shared.shell {
                Some(shell) => {
                    let reply = shell.call(command, bytes);
                    if reply.painted.is_some() {
                        shared.cells = shell.cells();
                    }
                    message::write(&reply)
                }
                None => message::fault("nothing is open yet"),
            },
            Err(error) => message::fault(&error),
        };
        shared.reply.len()
    })
}

/// Where that lies.
#[unsafe(no_mangle)]
pub extern "C" fn carrom_reply() -> *const u8 {
    SHARED.with_borrow(|shared| shared.reply.as_ptr())
}

/// Where the cells lie that were painted last, row by row, four numbers each: the letter,
/// the colour of what is written and the colour behind it (0xRRGGBB), and bits for bold (1),
/// italic (4), underlined (8) and for what a picture takes the place of (2¹⁶).
#[unsafe(no_mangle)]
pub extern "C" fn carrom_cells() -> *const u32 {
    SHARED.with_borrow(|shared| shared.cells.as_ptr())
}

//! The functions that the page calls by name, and the memory that both sides use.
//!
//! The page has one thread. It requests a buffer, writes its command there and calls
//! [`carrom_call`]; the reply is at the address returned by [`carrom_reply`] until the
//! next call.

use std::cell::RefCell;

use crate::message::{self, Command};
use crate::shell::Shell;

/// The memory that both sides share.
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

/// Makes a buffer of `bytes` bytes for the page's command; returns the buffer's address.
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

/// The address of the reply.
#[unsafe(no_mangle)]
pub extern "C" fn carrom_reply() -> *const u8 {
    SHARED.with_borrow(|shared| shared.reply.as_ptr())
}

/// The address of the cells painted last, row by row, four numbers each: the letter, the
/// colours of the letter and of its background (0xRRGGBB), and bits for bold (1), italic (4),
/// underlined (8) and a cell that a picture replaces (2¹⁶).
#[unsafe(no_mangle)]
pub extern "C" fn carrom_cells() -> *const u32 {
    SHARED.with_borrow(|shared| shared.cells.as_ptr())
}

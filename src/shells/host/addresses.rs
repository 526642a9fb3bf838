//! Where this computer is reached in its networks.

use std::net::{IpAddr, Ipv4Addr, UdpSocket};

/// An address that is nobody's, to ask which way leads out; nothing is sent there.
const ELSEWHERE: (Ipv4Addr, u16) = (Ipv4Addr::new(192, 0, 2, 1), 9);

/// The addresses of this computer with this port: the one towards the network first, and that
/// of the computer itself where there is no network.
pub(super) fn own(port: u16) -> Vec<String> {
    let interfaces = if_addrs::get_if_addrs().unwrap_or_default();
    let mut own: Vec<Ipv4Addr> = interfaces
        .iter()
        .filter_map(|it| match it.ip() {
            IpAddr::V4(ip) if !ip.is_loopback() && !ip.is_link_local() => Some(ip),
            _ => None,
        })
        .collect();
    let outward = outward();
    own.sort_by_key(|ip| (Some(*ip) != outward, !ip.is_private(), *ip));
    own.dedup();
    if own.is_empty() {
        own.push(Ipv4Addr::LOCALHOST);
    }
    own.iter().map(|ip| format!("{ip}:{port}")).collect()
}

/// The address that others in the network see.
fn outward() -> Option<Ipv4Addr> {
    let socket = UdpSocket::bind((Ipv4Addr::UNSPECIFIED, 0)).ok()?;
    socket.connect(ELSEWHERE).ok()?;
    match socket.local_addr().ok()?.ip() {
        IpAddr::V4(ip) => Some(ip),
        IpAddr::V6(_) => None,
    }
}

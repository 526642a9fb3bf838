//! The addresses of this computer on the local network.

use std::net::{IpAddr, Ipv4Addr, SocketAddrV4, UdpSocket};

/// An unused address, to find the outgoing interface; nothing is sent there.
const ELSEWHERE: (Ipv4Addr, u16) = (Ipv4Addr::new(192, 0, 2, 1), 9);

/// The addresses of this computer with this port: first the address that devices used before, then
/// that of the outgoing interface; the loopback address if there is no network.
pub(super) fn own(port: u16, before: Option<SocketAddrV4>) -> Vec<SocketAddrV4> {
    let interfaces = if_addrs::get_if_addrs().unwrap_or_default();
    let mut own: Vec<Ipv4Addr> = interfaces
        .iter()
        .filter_map(|it| match it.ip() {
            IpAddr::V4(ip) if !ip.is_loopback() && !ip.is_link_local() => Some(ip),
            _ => None,
        })
        .collect();
    let (before, outward) = (before.map(|it| *it.ip()), outward());
    let is_later = |ip: Ipv4Addr| [before, outward].map(|first| first != Some(ip));
    own.sort_by_key(|ip| (is_later(*ip), !ip.is_private(), *ip));
    own.dedup();
    if own.is_empty() {
        own.push(Ipv4Addr::LOCALHOST);
    }
    own.into_iter()
        .map(|ip| SocketAddrV4::new(ip, port))
        .collect()
}

/// The address of this computer on the outgoing interface.
fn outward() -> Option<Ipv4Addr> {
    let socket = UdpSocket::bind((Ipv4Addr::UNSPECIFIED, 0)).ok()?;
    socket.connect(ELSEWHERE).ok()?;
    match socket.local_addr().ok()?.ip() {
        IpAddr::V4(ip) => Some(ip),
        IpAddr::V6(_) => None,
    }
}

# Functions that install Debian and Ubuntu systems into folders and run commands in them (chroot). Need root and debootstrap.

# Prints the Debian mirror: $MIRROR, or else the mirror that this machine uses.
debian_mirror() {
  local found
  found=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources} 2>/dev/null |
    sed -n 's/^URIs: *\([^ ]*\).*/\1/p; s/^deb [^h]*\(http[^ ]*\).*/\1/p' | head -1 || true)
  echo "${MIRROR:-${found:-http://deb.debian.org/debian}}"
}

require_debian_root() {
  command -v debootstrap >/dev/null || { echo "$0 needs debootstrap: apt-get install debootstrap" >&2; exit 2; }
  [[ $(id -u) -eq 0 ]] || { echo "$0 must run as root: it installs Debian into a folder" >&2; exit 2; }
}

# make_debian_root SUITE FOLDER: installs a minimal system. SUITE: bookworm, trixie, sid (Debian) or noble (Ubuntu). Copies this
# machine's name server, apt settings and certificate authorities.
make_debian_root() {
  local suite=$1 root=$2
  case $suite in
    # debootstrap of Debian 12 has no script for noble; the script for gutsy fits every suite of Ubuntu.
    noble) debootstrap --variant=minbase --components=main,universe noble "$root" "${UBUNTU_MIRROR:-http://archive.ubuntu.com/ubuntu}" gutsy ;;
    *) debootstrap --variant=minbase "$suite" "$root" "$(debian_mirror)" ;;
  esac || return
  cp /etc/resolv.conf "$root/etc/" 2>/dev/null || true
  cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"
  mkdir -p "$root/usr/local/share"
  cp -r /usr/local/share/ca-certificates "$root/usr/local/share/"
  in_debian_root "$root" apt-get update -qq
}

# in_debian_root FOLDER COMMAND...: runs a command in the system in FOLDER. Unmounts everything when the command ends.
in_debian_root() {
  local root=$1
  shift
  # shellcheck disable=SC2016
  unshare --mount --propagation private bash -c '
    root=$1; shift
    mount --rbind /dev "$root/dev" && mount --rbind /sys "$root/sys" && mount -t proc proc "$root/proc" || exit
    exec chroot "$root" "$@"' _ "$root" \
    /usr/bin/env -i HOME=/root TERM="${TERM:-dumb}" PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"
}

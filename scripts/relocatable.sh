# Functions that collect the libraries on which a program depends, and their licences.
# shellcheck shell=bash

# Prints the comment at the top of a script.
print_help() { sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "$1"; }

# require_programs PROGRAM:PACKAGE ...: ends the script with an error that names the packages of all missing programs.
require_programs() {
  local entry missing=()
  for entry in "$@"; do command -v "${entry%%:*}" >/dev/null || missing+=("${entry##*:}"); done
  [[ ${#missing[@]} -eq 0 ]] || { echo "$0: missing packages: apt-get install ${missing[*]}" >&2; exit 2; }
}

# Prints the Debian package that installed a file. Debian lists some files below /lib and others below /usr/lib.
package_of() {
  local file
  file=$(readlink -f "$1")
  { dpkg-query -S "${file#/usr}" 2>/dev/null || dpkg-query -S "/usr${file#/usr}" 2>/dev/null || echo "no package:"; } | sed 's/:.*//; q'
}

# Prints "package path" of each library that the given files load, directly or indirectly. Leaves out glibc, which must match the
# machine on which the program runs.
libraries_of() {
  local loaded path
  loaded=$(for file in "$@"; do ldd "$file"; done)
  if grep -q 'not found' <<<"$loaded"; then
    echo "$0: a library is missing: $(grep -m1 'not found' <<<"$loaded")" >&2
    return 1
  fi
  for path in $(awk '$3 ~ /^\// {print $3}' <<<"$loaded" | LC_ALL=C sort -u); do
    echo "$(package_of "$path") $path"
  done | sed '/^libc6 /d'
}

# Prints "package path" of oneTBB's allocator, which ldd does not list, because oneTBB loads it at run time.
allocator_of_tbb() {
  local path
  path=$(awk '/\/libtbb\.so\./ {sub(/libtbb\.so\..*/, "libtbbmalloc.so.2", $2); print $2}')
  [[ -e $path ]] && echo "$(package_of "$path") $path"
}

# copy_licences FOLDER LIST: copies the licences of packages to FOLDER and writes their versions to LIST. Reads package names from
# standard input.
copy_licences() {
  local package
  while read -r package; do
    cp -L "/usr/share/doc/$package/copyright" "$1/$package.copyright"
    dpkg-query -W -f='${Package} ${Version} (source: ${source:Package} ${source:Version})\n' "$package" | head -1
  done >"$2"
}

# Packages of static libraries and headers that are compiled into the program.
# shellcheck disable=SC2034
compiled_in=(libcli11-dev libdraco-dev libfmt-dev libglm-dev libmeshoptimizer-dev libstb-dev libtomlplusplus-dev libxxhash-dev
  nlohmann-json3-dev)

licence_notes() {
  cat <<NOTES
Lippmann is under the Apache License 2.0 (LICENSE). The libraries of others in this $1 come unchanged from the Debian packages that
packages.txt lists; only their search paths, symbol tables and file names may differ. NAME.copyright holds the licence of each.

libjbig, which libtiff loads, is under the GNU General Public License, version 2 or later. Whoever passes this $1 on must
follow the terms of that licence.
NOTES
  if [[ $2 == yes ]]; then
    echo
    echo "So are FFmpeg as Debian builds it and some codecs, such as x264 and x265."
  fi
  cat <<'NOTES'

The source of each package: apt-get source NAME=VERSION on the Debian release, or https://snapshot.debian.org.
NOTES
}

# All files get this time stamp, so that equal inputs make equal archives.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || echo 1000000000)}
export SOURCE_DATE_EPOCH

# Read by run.sh and test.sh: installs the packages that are missing and configures the release build.
# Afterwards: $root is the top of the project, $build the build folder.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$root/build/release"

missing_packages() {
    local package
    while read -r package; do
        case "$package" in '' | \#*) continue ;; esac
        [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || echo "$package"
    done < "$root/scripts/packages.txt"
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

install_missing() {
    command -v dpkg-query >/dev/null || { echo "not a Debian system: install the packages of scripts/packages.txt by other means" >&2; return 0; }
    local packages
    mapfile -t packages < <(missing_packages)
    [ "${#packages[@]}" -eq 0 ] && return 0
    echo "installing: ${packages[*]}"
    as_root apt-get -q update
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-install-recommends "${packages[@]}"
}

configure() {
    (cd "$root" && cmake --preset release "$@")
}

install_missing

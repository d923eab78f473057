#!/usr/bin/env bash
# Installs what this machine lacks of what is named: `scripts/setup.sh NEED...`
#
#   rust         checks for cargo; says where to get it
#   make         make
#   compiler     a C compiler's linker, which rustc calls
#   vulkan       a Vulkan driver; Mesa's, in software, if there is none
#   lints        rustfmt and clippy
#   swiftshader  a second software Vulkan driver, which Debian's chromium ships
#
# What is there is left alone. What is installed is announced first.
set -euo pipefail

# ldconfig lies here, where a user's PATH does not always lead.
PATH="$PATH:/usr/sbin:/sbin"

say() { printf 'setup: %s\n' "$*" >&2; }
have() { command -v "$1" >/dev/null 2>&1; }

give_up() {
    say "$@"
    exit 1
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif have sudo; then
        sudo "$@"
    else
        give_up "this takes root: run as root, or install sudo: $*"
    fi
}

updated=no
update_lists() {
    [ "$updated" = no ] || return 0
    for pause in 5 15 45 0; do
        if as_root apt-get update; then
            updated=yes
            return 0
        fi
        say "apt-get update failed"
        sleep "$pause"
    done
    return 1
}

# apt_install WHY PACKAGE...
apt_install() {
    local why="$1"
    shift
    have apt-get || give_up "$why: this system has no apt-get; install by its own means what Debian calls: $*"
    say "$why: installing $* with apt-get"
    update_lists || say "going on with the package lists as they are"
    as_root env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y --no-install-recommends "$@"
}

need_rust() {
    have cargo || give_up "there is no cargo: install Rust 1.90 or later, see https://rustup.rs"
}

need_make() {
    have make || apt_install "there is no make" make
}

need_compiler() {
    have cc || apt_install "there is no C compiler to link with" gcc libc6-dev
}

# The loader, and a file that tells it of a driver. Whether that driver finds a
# device, `rayproof doctor` says.
vulkan_is_there() {
    ldconfig -p 2>/dev/null | grep -F libvulkan.so.1 >/dev/null || return 1
    [ -z "${VK_DRIVER_FILES:-}${VK_ICD_FILENAMES:-}" ] || return 0
    local folder
    for folder in /etc /usr/share /usr/local/share "${XDG_DATA_HOME:-${HOME:-}/.local/share}"; do
        compgen -G "$folder/vulkan/icd.d/*.json" >/dev/null && return 0
    done
    return 1
}

need_vulkan() {
    # Elsewhere the system brings an interface of its own: Metal, Direct3D 12.
    [ "$(uname -s)" = Linux ] || return 0
    vulkan_is_there || apt_install "there is no Vulkan driver" mesa-vulkan-drivers libvulkan1
    vulkan_is_there || give_up "there is still no Vulkan driver to be found"
}

need_lints() {
    local component
    for component in rustfmt clippy; do
        cargo "${component#rust}" --version >/dev/null 2>&1 && continue
        have rustup || give_up "$component is missing, and there is no rustup to add it with"
        say "adding $component with rustup"
        rustup component add "$component"
    done
}

need_swiftshader() {
    local icd=/usr/lib/chromium/vk_swiftshader_icd.json
    # Google's Chrome brings it as well.
    [ ! -e "$icd" ] && [ ! -e /opt/google/chrome/vk_swiftshader_icd.json ] || return 0
    apt_install "there is no SwiftShader" chromium-common
    [ -e "$icd" ] || give_up "chromium-common brings no $icd"
}

for need in "$@"; do
    case "$need" in
        rust | make | compiler | vulkan | lints | swiftshader) "need_$need" ;;
        *) give_up "nothing is called $need" ;;
    esac
done

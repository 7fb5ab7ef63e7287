#!/usr/bin/env bash
# Make .venv with everything that rigtrue needs, and see that this machine can render.
#   ./setup.sh            Python packages and off-screen OpenGL
#   ./setup.sh browser    a Chromium for the test of the report
# System packages come by apt where this user may install them; elsewhere the exact command is printed.
set -euo pipefail
cd "$(dirname "$0")"

say() { echo "setup: $*" >&2; }

apt_install() {
    local install="apt-get install -y --no-install-recommends $*"
    if ! command -v apt-get >/dev/null; then
        say "install what Debian calls '$*' with this system's package manager, then run this again"
        exit 1
    elif [ "$(id -u)" = 0 ]; then
        say "$install"
        apt-get update -qq && DEBIAN_FRONTEND=noninteractive $install -qq >/dev/null </dev/null
    elif sudo -n true 2>/dev/null; then
        say "sudo $install"
        sudo -n apt-get update -qq && sudo -n DEBIAN_FRONTEND=noninteractive $install -qq >/dev/null </dev/null
    else
        say "this needs system packages that only an administrator may install; run this, then try again:"
        echo "    sudo apt-get update && sudo $install" >&2
        exit 1
    fi
}

find_python() {
    local name
    for name in python3 python3.13 python3.12 python3.11; do
        if "$name" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
            echo "$name"
            return
        fi
    done
    say "no Python 3.11 or newer on the PATH, found: $(python3 --version 2>&1 || true)"
    exit 1
}

make_venv() {
    if .venv/bin/python -m pip --version >/dev/null 2>&1; then return; fi
    local python version
    python=$(find_python)
    version=$("$python" -c 'import sys; print("python%d.%d" % sys.version_info[:2])')
    # Debian splits the standard library: venv needs ensurepip, which is a package of its own there.
    "$python" -c 'import ensurepip, venv' 2>/dev/null || apt_install "$version-venv"
    "$python" -m venv --clear .venv
}

install_packages() {
    say "installing Python packages, a minute or two"
    .venv/bin/python -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements.lock
    .venv/bin/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation -e .
}

can_render() {
    .venv/bin/python -c 'import sys; from sim.rendering.gl import probe_gl; sys.exit(probe_gl().problem is not None)'
}

see_that_it_renders() {
    can_render || apt_install libegl1 libgl1 libgl1-mesa-dri
    can_render || { .venv/bin/rigtrue doctor >&2 || true; exit 1; }
}

can_draw_filament() {
    .venv/bin/python -c 'import sys; from sim.rendering.choice import probe; sys.exit(probe("filament").problem is not None)'
}

offer_filament() {
    local packages="libvulkan1 mesa-vulkan-drivers"
    if can_draw_filament; then return; fi
    if command -v apt-get >/dev/null && { [ "$(id -u)" = 0 ] || sudo -n true 2>/dev/null; }; then
        (apt_install $packages) || true  # judged below
    fi
    can_draw_filament || say "optional: the renderer 'filament' needs Vulkan (what Debian calls '$packages'); all else works"
}

has_browser() {
    local name
    for name in chromium chromium-browser google-chrome; do
        # Being there is not enough: Ubuntu's package is a stub that starts a snap, which containers cannot.
        if timeout 60 "$name" --version >/dev/null 2>&1 </dev/null; then return; fi
    done
    return 1
}

install_browser() {
    if has_browser; then return; fi
    if ! grep -qs '^ID=ubuntu' /etc/os-release; then
        apt_install chromium
    elif snap list >/dev/null 2>&1; then
        apt_install chromium-browser || true  # judged below
    fi
    if ! has_browser; then say_how_to_get_chrome; exit 1; fi
}

say_how_to_get_chrome() {
    local sudo="sudo " deb=google-chrome-stable_current_amd64.deb
    if [ "$(id -u)" = 0 ]; then sudo=""; fi
    say "no chromium, chromium-browser or google-chrome on the PATH starts (tried with --version)"
    if [ "$(uname -m)" = x86_64 ] && command -v apt-get >/dev/null; then
        say "run this, then try again:"
        echo "    ${sudo}apt-get update && ${sudo}apt-get install -y curl ca-certificates" >&2
        echo "    curl -fLo /tmp/$deb https://dl.google.com/linux/direct/$deb" >&2
        echo "    ${sudo}apt-get install -y /tmp/$deb" >&2
    else
        say "put a Chromium that starts on the PATH under one of these names, then try again"
    fi
}

case "${1:-}" in
    "") make_venv; install_packages; see_that_it_renders; offer_filament; say "ready" ;;
    browser) install_browser ;;
    *) say "got '$1', wanted nothing or 'browser'"; exit 2 ;;
esac

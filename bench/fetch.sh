# SPDX-License-Identifier: Apache-2.0
# Brings packages that are unpacked and not installed; ./dev reads it. Each comes through its
# registry's own client.

# unpack_apart ARCHIVE FOLDER: by what the archive's name ends with.
unpack_apart() {
    case $1 in
        *.whl) unzip -qo "$1" -d "$2" ;;
        *.deb) dpkg-deb -x "$1" "$2" ;;
        *.tgz | *.crate) tar -xzf "$1" -C "$2" ;;
    esac
}

# fetch KIND:NAME: into build/fetched/NAME, unless it is there.
fetch() {
    local kind=${1%%:*} package=${1#*:} name folder archives
    name=${package%%[=@]*}
    folder=$PWD/build/fetched/$name
    [[ ! -d $folder ]] || return 0
    say "fetching $package"
    archives=$(mktemp -d)
    # apt fetches as a user of its own.
    chmod 755 "$archives"
    case $kind in
        pypi) python3 -m pip download --quiet --no-deps --only-binary :all: -d "$archives" "$package" ;;
        npm) (cd "$archives" && npm pack --silent "$package" >/dev/null) ;;
        deb) (cd "$archives" && apt-get download -qq "$package" >/dev/null 2>&1) ;;
        crate) fetch_crate "$name" "${package#*@}" "$archives" ;;
        *) die "dependencies.txt: no kind of package is called '$kind'" ;;
    esac || say "fetch: $package is not to be had"
    mkdir -p "$folder.partial"
    local archive
    for archive in "$archives"/*; do
        if [[ -f $archive ]]; then unpack_apart "$archive" "$folder.partial"; fi
    done
    rm -r "$archives"
    # What failed is tried again next time.
    if [[ $(ls -A "$folder.partial") ]]; then mv "$folder.partial" "$folder"; else rmdir "$folder.partial"; fi
}

# fetch_crate NAME VERSION FOLDER: cargo fetches for a project alone, so it gets one that has nothing
# but that dependency.
fetch_crate() {
    local project=$3/project home=$3/home
    mkdir -p "$project/src"
    : >"$project/src/lib.rs"
    printf '[package]\nname = "fetch"\nversion = "0.0.0"\nedition = "2021"\n[dependencies]\n%s = "=%s"\n' \
        "$1" "$2" >"$project/Cargo.toml"
    CARGO_HOME=$home cargo fetch --quiet --manifest-path "$project/Cargo.toml" || return 1
    mv "$home"/registry/cache/*/"$1-$2.crate" "$3/"
}

#!/usr/bin/env bash
# Carries out the recipes of CONTRIBUTING.md in a copy of the tree: a discrete method, an impact operator, a scene key, a
# check and a scene that do next to nothing. Compiles what they change, takes the rest from the libraries of the build, and
# runs a scene that shows each of them; counts the files that each recipe touches.
# Usage: recipes.sh SOURCE_DIR WORK_DIR COMPILER COMPILER_FLAGS EIGEN_INCLUDE LIBRARY...
set -euo pipefail
source=$1 work=$2 compiler=$3 eigen=$5
read -ra given_flags <<<"$4"
libraries=("${@:6}")
tree=$work/tree
rm -rf "$work"
mkdir -p "$tree"
cp -r "$source/include" "$source/src" "$source/scenes" "$tree"

die() { echo "$*" >&2; exit 1; }

# edit FILE PATTERN TEXT after|before|instead: a whole line TEXT beside, or in place of, the first line that has PATTERN.
edit() {
    local file=$tree/$1
    [ -f "$file" ] || die "no such file: $1"
    pattern=$2 text=$3 place=$4 awk '
        BEGIN { pattern = ENVIRON["pattern"]; text = ENVIRON["text"]; place = ENVIRON["place"] }
        !done && index($0, pattern) {
            done = 1
            if (place != "after") print text
            if (place != "instead") print
            if (place == "after") print text
            next
        }
        { print }
        END { exit !done }' "$file" >"$file.new" || die "$1 has no line with: $2"
    mv "$file.new" "$file"
}
# swap FILE OLD NEW: the first OLD in the file becomes NEW, within one line.
swap() {
    local file=$tree/$1
    [ -f "$file" ] || die "no such file: $1"
    old=$2 new=$3 awk '
        BEGIN { old = ENVIRON["old"]; new = ENVIRON["new"] }
        !done && (at = index($0, old)) { done = 1; $0 = substr($0, 1, at - 1) new substr($0, at + length(old)) }
        { print }
        END { exit !done }' "$file" >"$file.new" || die "$1 does not have: $2"
    mv "$file.new" "$file"
}
# In an array of names NAMES of the file: one more, at the end.
add_name() {
    local file=$1 names=$2 name=$3 size
    size=$(sed -nE "s/.*string_view, ([0-9]+)> $names\{.*/\1/p" "$tree/$file")
    [ -n "$size" ] || die "$file: no array $names"
    swap "$file" "string_view, $size> $names{" "string_view, $((size + 1))> $names{\"$name\", "
    # The new name goes to the end: rotate the list that begins behind the brace.
    names=$names awk '
        { all = all $0 "\n" }
        END {
            at = index(all, ENVIRON["names"] "{") + length(ENVIRON["names"]) + 1
            head = substr(all, 1, at - 1); rest = substr(all, at)
            close_at = index(rest, "}")
            list = substr(rest, 1, close_at - 1); tail = substr(rest, close_at)
            first = substr(list, 1, index(list, ",") - 1)
            list = substr(list, index(list, ",") + 1)
            gsub(/^[ \n]+/, "", list)
            printf "%s%s, %s%s", head, list, first, tail
        }' "$tree/$file" >"$tree/$file.new"
    mv "$tree/$file.new" "$tree/$file"
}

# recipe NAME MOST: runs the function NAME; at most MOST files may have changed.
recipe() {
    rm -rf "$work/before"
    cp -r "$tree" "$work/before"
    "$1"
    local touched
    touched=$({ diff -rq "$work/before" "$tree" || true; } | sed -E 's/^Files [^ ]+ and ([^ ]+) differ$/\1/; s/^Only in ([^:]+): /\1\//' |
        sed "s|^$tree/||" | sort)
    rm -rf "$work/before"
    echo "$touched" >>"$work/touched"
    local count
    count=$(wc -l <<<"$touched")
    echo "$1: $count files: $(tr '\n' ' ' <<<"$touched")"
    [ "$count" -le "$2" ] || die "$1 touches more than $2 files"
}

discrete_method() {
    edit include/carom/method.hpp '/// Each alternative says what users call it' \
        'struct Dummy : StepOptions {
    static constexpr std::string_view method_name = "dummy_method";
};
' before
    swap include/carom/method.hpp 'Speculative, Soft>;' 'Speculative, Soft, Dummy>;'
    edit src/stepping/stepping.hpp '}  // namespace carom' \
        'Outcome run_stepping(const Scene& scene, const Dummy& method, const RunOptions& options, const Observer& observer);
' before
    sed 's/Naive/Dummy/g' "$tree/src/stepping/naive.cpp" >"$tree/src/stepping/dummy.cpp"
    swap scenes/scene.schema.json '"speculative", "soft"]' '"speculative", "soft", "dummy_method"]'
}

# Everything sticks: the inelastic impact, whatever the restitutions.
impact_operator() {
    swap include/carom/response.hpp '    jacobi ' '    jacobi,'
    edit include/carom/response.hpp 'the pair law of all contacts at once' '    dummy  ///< inelastic, whatever the materials say' after
    add_name include/carom/response.hpp impact_operator_names dummy
    cat >"$tree/src/impact/dummy.cpp" <<'CODE'
#include "impact/operators.hpp"

namespace carom {

NormalImpact dummy(const ContactProblem& cluster)
{
    return inelastic(cluster);
}

}  // namespace carom
CODE
    edit src/impact/operators.hpp 'NormalImpact jacobi(' 'NormalImpact dummy(const ContactProblem& cluster);' after
    edit src/impact/resolve_cluster.cpp 'case ImpactOperator::jacobi:' \
        '        case ImpactOperator::dummy:
            return dummy(cluster);' before
    swap scenes/scene.schema.json '"shock", "jacobi"]' '"shock", "jacobi", "dummy"]'
}

scene_key() {
    edit include/carom/scene.hpp 'double end_time = 0;' '    double haste = 1;        ///< in [0, 1]' after
    edit src/io/scene_reader.cpp 'scene.seed = root.integer' \
        '    scene.haste = root.number("haste", fraction).value_or(scene.haste);' after
    edit src/io/scene_json.cpp 'json["seed"] = scene.seed;' '    json["haste"] = scene.haste;' after
    edit src/scene/validate.cpp 'positive("/end_time"' '        fraction("/haste", scene_.haste);' after
    edit scenes/scene.schema.json '"seed": {' '    "haste": {"$ref": "#/$defs/fraction", "default": 1},' before
}

# The largest speed at the end is 0.
check() {
    swap include/carom/scene.hpp '    mirrored ' '    mirrored,'
    edit include/carom/scene.hpp '    mirrored,' '    still' after
    add_name include/carom/scene.hpp check_type_names still
    edit src/scene/check_keys.hpp '{CheckType::mirrored, {CheckKey::value}},' '    {CheckType::still},' after
    edit src/study/checks.cpp 'case CheckType::inside:' \
        '            case CheckType::still:
                judge(check, velocity_deviation(outcome.final, std::vector<BodyState>(outcome.final.size())).max, 1);
                needs_end(false);
                break;' before
    edit include/carom/checks.hpp '/// | mirrored |' '/// | still | largest speed at the end [length/time] | 1 |' after
    swap scenes/scene.schema.json '"reversed", "mirrored"' '"reversed", "mirrored", "still"'
    swap scenes/scene.schema.json '"inside", "reversed"]' '"inside", "reversed", "still"]'
}

scene() {
    cat >"$tree/scenes/collisions/dummy.json" <<'JSON'
{
  "$schema": "../scene.schema.json",
  "format": "carom-scene/1",
  "name": "Dummy",
  "description": "Three balls that stick together: one at 3 m/s meets two that touch, and all go on at 1 m/s.",
  "units": {"length": "m", "time": "s", "mass": "kg"},
  "end_time": 2,
  "haste": 0.5,
  "impact": "dummy",
  "spheres": [
    {"id": "a", "radius": 0.5, "position": [-4, 0, 0], "velocity": [3, 0, 0]},
    {"id": "b", "radius": 0.5, "position": [0, 0, 0]},
    {"id": "c", "radius": 0.5, "position": [1, 0, 0]}
  ],
  "checks": [
    {"type": "event_time", "event": 0, "time": 1, "abs": 1e-15},
    {"type": "final_velocity", "body": "c", "value": [1, 0, 0], "abs": 1e-12},
    {"type": "still", "abs": 1.000000001}
  ]
}
JSON
}

program() {
    cat >"$work/main.cpp" <<'CODE'
#include <carom/checks.hpp>
#include <carom/io.hpp>

#include <cstdio>

// Runs a scene by two methods: every check of it holds by event, and a stepper of the new kind gets to its end.
int main(int, char** argv)
{
    try {
        const carom::Scene scene = carom::read_scene(argv[1]);
        const carom::CheckReport report = carom::check_scene(scene);
        for (const carom::CheckResult& each : report.results)
            std::printf("%s: %s, %s\n", each.what.c_str(), carom::name(each.verdict), each.message.c_str());
        const carom::Outcome stepped = carom::simulate(scene, carom::make_method("dummy_method"));
        std::printf("dummy_method: %s, haste %g\n", carom::name(stepped.status), scene.haste);
        return report.all_hold() && stepped.status == carom::Status::reached_end && stepped.counts.steps > 0 &&
                       scene.haste == 0.5
                   ? 0
                   : 1;
    } catch (const carom::InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
CODE
}

# Those of the sources named that the recipes touched, or that include such a header, however far away.
affected() {
    grep -oE '(carom/.*|src/.*)\.hpp$' "$work/touched" | sed 's|^src/||' | sort -u >"$work/headers"
    local before=0
    while [ "$(wc -l <"$work/headers")" -gt "$before" ]; do
        before=$(wc -l <"$work/headers")
        (cd "$tree" && grep -rlF --include='*.hpp' -f "$work/headers" include src) | sed -E 's/^(include|src)\///' |
            sort -u - "$work/headers" >"$work/headers.new"
        mv "$work/headers.new" "$work/headers"
    done
    (cd "$tree/src" && { grep -lF -f "$work/headers" "$@"; sed -n 's/^src\///p' "$work/touched" | grep '\.cpp$'; } | sort -u)
}

# The library up to runs with checks; not what certifies, records, reports and compares.
build() {
    local folders
    folders=$(sed -n 's/^set(CAROM_CORE_FOLDERS \(.*\))$/\1/p' "$source/CMakeLists.txt" | sed 's/ verify / /')
    [ -n "$folders" ] || die "CMakeLists.txt has no CAROM_CORE_FOLDERS"
    local sources units
    mapfile -t sources < <(cd "$tree/src" && find $folders -name "*.cpp" | sort &&
        ls io/scene_*.cpp study/{checks,check_scene,mirror_image,repeat_run,run_study,metrics,deepest_overlap,lift_watch}.cpp)
    mapfile -t units < <(affected "${sources[@]}")
    echo "${#units[@]} of ${#sources[@]} sources to compile"
    local flags=(-std=c++20 -O0 "${given_flags[@]}" -I"$tree/include" -I"$tree/src" -isystem "$eigen"
        -DEIGEN_DONT_VECTORIZE -DEIGEN_MAX_ALIGN_BYTES=16)
    # Eigen is most of what there is to read: once is enough.
    mkdir -p "$work/objects"
    cat >"$work/common.hpp" <<<'#include <carom/carom.hpp>'
    "$compiler" "${flags[@]}" -x c++-header "$work/common.hpp" -o "$work/common.hpp.gch"
    printf '%s\n' "${units[@]}" | xargs -P "$(nproc)" -I{} sh -c \
        'unit=$1; shift; "$@" -include "$0/common.hpp" -c "$0/tree/src/$unit" -o "$0/objects/$(echo "$unit" | tr / _).o"' \
        "$work" {} "$compiler" "${flags[@]}"
    "$compiler" "${flags[@]}" "$work/main.cpp" "$work"/objects/*.o "${libraries[@]}" -o "$work/recipes"
}

recipe discrete_method 8
recipe impact_operator 5
recipe scene_key 8
recipe check 8
recipe scene 1
program
build
"$work/recipes" "$tree/scenes/collisions/dummy.json"

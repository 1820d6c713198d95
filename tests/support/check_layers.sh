#!/usr/bin/env bash
# A folder of src may include only what stands to its left in the order of the design. Usage: check_layers.sh SRC
set -euo pipefail
src=$1
# Folders on one line stand side by side: none of them sees the others.
order=("core" "math" "linear_algebra" "projection" "flight" "toi verify" "broad" "scene" "obstacle" "stepping" "queue contact window" "impact" "motion" "gather" "hold" "heap" "predict" "event_driven" "reference" "simulate" "study" "tunnel audit" "io report" "peers" "cli")
declare -A rank
for i in "${!order[@]}"; do for folder in ${order[$i]}; do rank[$folder]=$i; done; done

bad=0
for folder in "$src"/*/; do
    folder=$(basename "$folder")
    if [ -z "${rank[$folder]:-}" ]; then echo "src/$folder: not a layer (add it to the order)"; bad=1; continue; fi
    while IFS=: read -r file line include; do
        target=$(sed -E 's/.*"([a-z_]+)\/.*/\1/' <<<"$include")
        [ -n "${rank[$target]:-}" ] || { echo "$file:$line: includes unknown layer: $include"; bad=1; continue; }
        if [ "$target" != "$folder" ] && [ "${rank[$target]}" -ge "${rank[$folder]}" ]; then
            echo "$file:$line: $folder may not include $target"
            bad=1
        fi
    done < <(grep -rnH --include='*.?pp' '#include "[a-z_]*/' "$src/$folder" 2>/dev/null | sed "s|$src/|src/|")
    # The stepping methods and the reference must not lean on the event engine, nor the reference on anything above math.
    case $folder in
    stepping) forbidden='"(linear_algebra|projection|toi|broad|queue|impact|contact|motion|gather|hold|heap|predict|flight)/' ;;
    reference) forbidden='"(linear_algebra|projection|flight|toi|broad|stepping|queue|impact|contact|motion|gather|hold|heap|predict|event_driven)/' ;;
    # What is certified must not help to certify.
    toi | broad | scene | obstacle | window | queue | impact | contact | motion | gather | hold | heap | predict | event_driven | simulate | study | tunnel | audit | report | peers) forbidden='"verify/' ;;
    *) continue ;;
    esac
    if grep -rnHE --include='*.?pp' "#include $forbidden" "$src/$folder"; then echo "src/$folder: must stay independent"; bad=1; fi
    # The reference knows materials and impact operators; what the engine takes for rest, and when it gives up, is no truth.
    if [ "$folder" = reference ] &&
        grep -rnHE --include='*.?pp' '#include "(core/[^p]|core/p[^a]|math|scene|obstacle)|rest_thresholds|RestThresholds|RestOptions|RestPolicy|GuardOptions|scene_?\.(rest|guard)\b' "$src/$folder"; then
        echo "src/$folder: must read no threshold of rest or guard, and of scenes nothing but plain data and material laws"
        bad=1
    fi
done
exit $bad

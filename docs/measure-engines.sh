#!/usr/bin/env bash
# Prints the measured tables of docs/engines.md: every shipped project on every common scenario.
# Takes about half an hour. Usage, from the root: docs/measure-engines.sh [build/release/bin/roversim]
set -euo pipefail
cd "$(dirname "$0")/.."
roversim=${1:-build/release/bin/roversim}

# measure PROJECT SCENARIO CONTROLLER [OPTION...]: one run, as the JSON text in $report
measure() {
    local project=$1 scenario=$2 controller=$3
    shift 3
    report=$("$roversim" run "assets/projects/$project.rover" --scenario "$scenario" --controller "$controller" "$@" --json) ||
        [ -n "$report" ]
}

# value KEY: of the report's top level
value() { sed -n "s/^  \"$1\": \"\{0,1\}\([^\",]*\)\"\{0,1\},\{0,1\}$/\1/p" <<<"$report"; }

# row FORMAT KEY...: the values of keys, one printf format each, as cells of a table
row() {
    local formats=$1 line='|' key format
    shift
    for key in "$@"; do
        format=${formats%% *}
        formats=${formats#* }
        # shellcheck disable=SC2059  # the format is one of ours
        line+=" $(printf "$format" "$(value "$key")") |"
    done
    printf '%s\n' "$line"
}

echo "| project | scenario | controller | end | slip_abs [m] | violation [%] | loop [mm] | penetration [mm] | solves/step | rtf |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
for project in solero shrimp bench_rover rocker_bogie; do
    for scenario in rough-profile rough-3d step flat; do
        for controller in speed equal-torque; do
            measure $project $scenario $controller
            printf '| %s | %s | %s ' $project $scenario $controller
            row "%s %.3f %.2f %.4f %.2f %.2f %.1f" stop_reason slip_abs_m friction_violation_pct loop_error_max_mm \
                penetration_max_mm solves_per_step rtf
        done
    done
done

echo
echo "| step [ms] | end | slip_abs [m] | slip_signed [m] | energy [J] | violation [%] | loop [mm] | penetration [mm] | solves/step | rtf |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
for step in 0.0005 0.001 0.002; do
    measure solero rough-profile speed --dt $step
    printf '| %s ' "$(awk "BEGIN { print 1000 * $step }")"
    row "%s %.3f %.3f %.2f %.2f %.4f %.2f %.2f %.1f" stop_reason slip_abs_m slip_signed_m energy_J friction_violation_pct \
        loop_error_max_mm penetration_max_mm solves_per_step rtf
done

#!/usr/bin/env bash
# Runs every study that ships and refreshes results/reference/<study>/. Archives of all evaluations stay in results/.
set -euo pipefail
cd "$(dirname "$0")/.."
program=build/release/bin/coilwright
scripts/setup.sh
cmake --preset release
cmake --build --preset release --target programs

# run STUDY COMMAND: the study's file is configs/studies/STUDY.json
run() {
  local study=$1 command=$2 config=configs/studies/$1.json
  echo "== $command $study"
  "$program" "$command" "$config" --out "results/$study" --force --quiet >"results/$study.txt"
  local reference=results/reference/$study
  rm -rf "$reference"
  mkdir -p "$reference"
  mv "results/$study.txt" "$reference/summary.txt"
  for file in result.json actuator.json front.csv designs.csv best.csv; do
    if [[ -f results/$study/$file ]]; then cp "results/$study/$file" "$reference/$file"; fi
  done
  printf '{\n  "command": "coilwright %s %s",\n  "commit": "%s",\n  "config_sha256": "%s",\n  "seed": %s\n}\n' \
    "$command" "$config" "$(git rev-parse HEAD)" "$(sha256sum "$config" | cut -d' ' -f1)" \
    "$(grep -o '"seed": [0-9]*' "$config" | grep -o '[0-9]*$')" >"$reference/reference.json"
}

mkdir -p results/reference/paper_finger
"$program" validate >results/reference/paper_finger/summary.txt
"$program" validate --json >results/reference/paper_finger/result.json

# Before the size studies: one of them starts from the actuator that this diagnosis hands back.
data=studies/undeclared_effect/data
echo "== diagnose $data"
"$program" diagnose "$data" --out results/undeclared_effect --seed 1 2>results/undeclared_effect.log >/dev/null
mkdir -p results/reference/undeclared_effect
for file in diagnosis.json actuator.json summary.txt; do
  cp "results/undeclared_effect/$file" "results/reference/undeclared_effect/$file"
done
run undeclared_before size
run undeclared_after size
# the design found before, with what is known after
"$program" evaluate results/reference/undeclared_effect/actuator.json --current-A 1.2 --duty 0.6 \
  --set turns_radial=18 --set turns_axial=13 --set wire_gauge_AWG=29 --set magnet_radius_mm=10 \
  --set magnet_length_mm=14 --set gap_mm=0.6 --set bottom_layer_mm=1.8 \
  >results/reference/undeclared_effect/uncorrected_design.txt
run undeclared_robust size
# What builds of the three designs do on the finger as it really is.
truth() {
  local of=$1
  shift
  "$program" yield configs/studies/undeclared_truth.json studies/undeclared_effect/truth.json --current-A 1.2 --builds 10000 \
    --quiet "${@/#/--set=}" >"results/reference/undeclared_robust/truth_of_$of.txt"
}
truth undeclared_before wire_gauge_AWG=29 turns_radial=18 turns_axial=13 magnet_radius_mm=10 magnet_length_mm=14 gap_mm=0.6 \
  bottom_layer_mm=1.8
truth undeclared_after wire_gauge_AWG=29 turns_radial=23 turns_axial=17 magnet_radius_mm=10 magnet_length_mm=6 gap_mm=0.6 \
  bottom_layer_mm=3.6
truth undeclared_robust wire_gauge_AWG=29 turns_radial=22 turns_axial=16 magnet_radius_mm=10 magnet_length_mm=6.5 gap_mm=0.6 \
  bottom_layer_mm=3.6
"$program" yield configs/studies/undeclared_robust.json results/reference/undeclared_robust/actuator.json --builds 10000 --quiet \
  >results/reference/undeclared_robust/yield_of_undeclared_robust.txt

echo "== paper_residual"
mkdir -p results/reference/paper_residual
python3 studies/paper_residual/residual.py "$program" >results/reference/paper_residual/summary.txt

echo "== gripper"
python3 -B studies/gripper/gripper.py "$program" results/reference/gripper

echo "== force_by_finite_elements"  # needs gmsh and getdp, and says so
mkdir -p results/reference/force_by_finite_elements
python3 -B studies/force_by_finite_elements/force.py "$program" >results/force_by_finite_elements.txt
mv results/force_by_finite_elements.txt results/reference/force_by_finite_elements/summary.txt

echo "== crawling_robot"
mkdir -p results/reference/crawling_robot
python3 studies/crawling_robot/crawl.py "$program" >results/reference/crawling_robot/summary.txt

run configurations sweep
for letter in A B C D; do run "best_$letter" size; done
run fastest_finger size
run strongest_grip size
run least_ringing size
for study in finger grip ringing A B C; do run "robust_$study" size; done
run grip_per_mass size
run split_currents size
run speed_against_grip pareto
run speed_grip_mass pareto
run lightest_gripper size
# What dice make of the nominal design and of the robust one.
yield() {
  "$program" yield "configs/studies/$1.json" "results/reference/$2/actuator.json" --quiet "${@:4}" >"results/reference/$3"
}
for pair in "robust_finger fastest_finger" "robust_grip strongest_grip" "robust_ringing least_ringing" "robust_A best_A" \
  "robust_B best_B" "robust_C best_C"; do
  read -r robust nominal <<<"$pair"
  for of in "$nominal" "$robust"; do yield "$robust" "$of" "$robust/yield_of_$of.txt" --builds 10000; done
done
yield robust_finger robust_finger robust_finger/worth.txt --builds 1000 --worth 1024
yield robust_grip robust_grip robust_grip/worth.txt --builds 1000 --worth 256
# Searches of an hour and more: only what builds make of the nominal designs.
yield robust_D best_D best_D/yield_of_best_D.txt --builds 1000
yield robust_gripper lightest_gripper lightest_gripper/yield_of_lightest_gripper.txt --builds 10000
run gripper_friction pareto
run fastest_crawler size
run crawler_range pareto

echo "== fastest_crawler: other frictions"
python3 -B studies/fastest_crawler/friction.py "$program" results/reference/fastest_crawler \
  >results/reference/fastest_crawler/friction.txt

"""From camera data to the corrected design: records in memory, a diagnosis, and what the design does in truth."""

# %% What a camera would give: here synthetic, of a finger that the air slows more than its model says.
import coilwright as cw

finger = cw.Actuator.load("configs/actuators/paper_finger.json")
truth = {"quadratic_drag": {"drag_Nmms2_rad2": 0.0116}}
camera = cw.twin(finger, "configs/experiments/paper.json", truth, seed=3)

# %% In an experiment of yours the arrays come from the tracker. Columns are called as they would be in a file.
runs = {file: {column: camera[file][column] for column in camera[file].columns} for file in camera}
records = cw.Records.of(runs, about={entry["file"]: entry for entry in camera.dataset["runs"]})

# %% What does the model lack?
diagnosis = cw.diagnose(records, finger)
print(diagnosis.verdict)
for effect, numbers in diagnosis.effects.items():
    for number in numbers:
        print(f"{effect}: {number.key} {number.value:.4f}, 95 % of {number.lower:.4f} to {number.upper:.4f}")
errors = diagnosis.errors
print(f"rms error on unseen runs {errors['declared']['rmse_deg']:.2f} deg as declared, "
      f"{errors['after']['rmse_deg']:.2f} deg corrected")

# %% The corrected actuator is one like any other. What was promised, and what it does:
for actuator in (finger, diagnosis.actuator):
    print(f"{cw.evaluate(actuator, current=1.4).peak_bending_speed_deg_s:.0f} deg/s")

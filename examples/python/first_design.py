"""A first design: what the paper's finger does, one change to it, and its motion."""

# %% What it does at 1.4 A. Every quantity is an attribute, in the unit of its name.
import coilwright as cw

finger = cw.Actuator.load("configs/actuators/paper_finger.json")
performance = cw.evaluate(finger, current=1.4)
print(f"steady angle {performance.steady_angle_deg:.1f} deg, grasp force {performance.grasp_force_N:.2f} N")

# %% A smaller gap: more force, and less room to move.
for gap in (0.6, 0.9, 1.2):
    changed = cw.evaluate(finger.replace(gap_mm=gap), current=1.4)
    print(f"gap {gap} mm: {changed.peak_bending_speed_deg_s:.0f} deg/s, {changed.mass_g:.1f} g")

# %% A value that does not exist says why.
try:
    print(cw.evaluate(finger, current=5).coil_hot_spot_degC)
except cw.NoPerformance as reason:
    print(reason)

# %% The motion after a step of the current, as arrays; motion.plot() draws it.
motion = cw.simulate(finger, step=1.4, duration=0.4)
print(f"largest angle {motion['bending_angle_deg'].max():.1f} deg after "
      f"{motion['time_s'][motion['bending_angle_deg'].argmax()]:.3f} s")

# %% The best of 60 designs within the study's limits, and what holds it back.
found = cw.size(cw.Study.load("configs/studies/fastest_finger.json"), max_evaluations=60, answer_only=True)
print(f"{cw.evaluate(found.best).peak_bending_speed_deg_s:.0f} deg/s within {cw.evaluate(found.best).mass_g:.1f} g")

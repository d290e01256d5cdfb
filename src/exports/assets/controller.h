/* Current to set `time` seconds after the start, A. */
static inline CW_REAL cw_profile_current(CW_REAL time) {
  CW_REAL current = CW_CURRENT_BEFORE_A;
  int i;
  for (i = 0; i < CW_LEVELS && time >= cw_level_time_s[i]; ++i) current = cw_level_current_A[i];
  return current;
}

/* Opening torque of a joint per ampere of the current, N m/A; beyond the table along its last slope. */
static inline CW_REAL cw_torque_per_ampere(int joint, CW_REAL angle) {
  const CW_REAL place = (angle - cw_table_first_rad[joint]) / cw_table_step_rad[joint];
  int i = place > 0 ? (int)place : 0;
  if (i > CW_TABLE - 2) i = CW_TABLE - 2;
  return cw_table_Nm_A[joint][i] + (place - (CW_REAL)i) * (cw_table_Nm_A[joint][i + 1] - cw_table_Nm_A[joint][i]);
}

/* Spring, damper, faces that touch, and magnetics, N m. */
static inline CW_REAL cw_joint_torque(int joint, CW_REAL angle, CW_REAL rate, CW_REAL current) {
  CW_REAL torque = cw_offset_Nm[joint] - cw_stiffness_Nm_rad[joint] * angle - cw_damping_Nms_rad[joint] * rate +
                   current * cw_torque_per_ampere(joint, angle);
  const CW_REAL closed = cw_closing_rad[joint] - angle;
  if (closed > 0) {
    const CW_REAL push = cw_contact_Nm_rad[joint] * closed - cw_contact_Nms_rad[joint] * rate;
    if (push > 0) torque += push;
  }
  return torque;
}

/* Joint accelerations, rad/s^2, at joint angles (rad) and rates (rad/s) under a current (A). */
static inline void cw_accelerations(const CW_REAL angle[CW_JOINTS], const CW_REAL rate[CW_JOINTS], CW_REAL current,
                             CW_REAL acceleration[CW_JOINTS]) {
  CW_REAL mass[CW_JOINTS][CW_JOINTS], force[CW_JOINTS];
  CW_REAL turn_x[CW_JOINTS], turn_y[CW_JOINTS]; /* of the next joint with the link, m/rad */
  CW_REAL bias_x = 0, bias_y = CW_GRAVITY;       /* of a joint, without accelerations of the angles, m/s^2 */
  CW_REAL absolute = CW_BASE_TILT_RAD, speed = 0;
  int i, j, k;
  for (i = 0; i < CW_JOINTS; ++i) {
    CW_REAL s, c, own_x, own_y, centre_x, centre_y;
    absolute += angle[i];
    speed += rate[i];
    s = sin(absolute);
    c = cos(absolute);
    own_x = cw_com_along_m[i] * c + cw_com_offset_m[i] * s;
    own_y = cw_com_along_m[i] * s - cw_com_offset_m[i] * c;
    centre_x = bias_x - speed * speed * (cw_com_along_m[i] * s - cw_com_offset_m[i] * c);
    centre_y = bias_y + speed * speed * (cw_com_along_m[i] * c + cw_com_offset_m[i] * s);
    force[i] = -cw_mass_kg[i] * (own_x * centre_x + own_y * centre_y);
    mass[i][i] = cw_inertia_kgm2[i] + cw_mass_kg[i] * (own_x * own_x + own_y * own_y);
    for (j = 0; j < i; ++j) {
      mass[i][j] = cw_mass_kg[i] * (own_x * turn_x[j] + own_y * turn_y[j]);
      force[j] -= cw_mass_kg[i] * (turn_x[j] * centre_x + turn_y[j] * centre_y);
      for (k = 0; k <= j; ++k) mass[j][k] += cw_mass_kg[i] * (turn_x[j] * turn_x[k] + turn_y[j] * turn_y[k]);
    }
    turn_x[i] = cw_length_m[i] * c;
    turn_y[i] = cw_length_m[i] * s;
    bias_x -= speed * speed * cw_length_m[i] * s;
    bias_y += speed * speed * cw_length_m[i] * c;
  }
  for (i = 0; i < CW_JOINTS; ++i) {
    const CW_REAL torque = cw_joint_torque(i, angle[i], rate[i], current);
    force[i] += torque;
    if (i > 0) force[i - 1] -= torque;
  }
  for (i = 0; i < CW_JOINTS; ++i) { /* Cholesky */
    for (j = 0; j <= i; ++j) {
      CW_REAL sum = mass[i][j];
      for (k = 0; k < j; ++k) sum -= mass[i][k] * mass[j][k];
      mass[i][j] = i == j ? sqrt(sum) : sum / mass[j][j];
    }
    for (k = 0; k < i; ++k) force[i] -= mass[i][k] * force[k];
    force[i] /= mass[i][i];
  }
  for (i = CW_JOINTS - 1; i >= 0; --i) {
    for (k = i + 1; k < CW_JOINTS; ++k) force[i] -= mass[k][i] * force[k];
    force[i] /= mass[i][i];
  }
  for (i = 0; i < CW_JOINTS; ++i) acceleration[i] = i > 0 ? force[i] - force[i - 1] : force[i];
}

/* Angles and rates `step` seconds later under a current that holds so long. Steps of CW_LARGEST_STEP_S
   and below. */
static inline void cw_step(CW_REAL angle[CW_JOINTS], CW_REAL rate[CW_JOINTS], CW_REAL current, CW_REAL step) {
  static const CW_REAL ahead[4] = {0, 0.5, 0.5, 1}, weight[4] = {1, 2, 2, 1};
  CW_REAL a[CW_JOINTS], w[CW_JOINTS], dw[CW_JOINTS], sum_a[CW_JOINTS], sum_w[CW_JOINTS], last_w[CW_JOINTS],
      last_dw[CW_JOINTS];
  int i, stage;
  for (i = 0; i < CW_JOINTS; ++i) sum_a[i] = sum_w[i] = last_w[i] = last_dw[i] = 0;
  for (stage = 0; stage < 4; ++stage) {
    for (i = 0; i < CW_JOINTS; ++i) {
      a[i] = angle[i] + ahead[stage] * step * last_w[i];
      w[i] = rate[i] + ahead[stage] * step * last_dw[i];
    }
    cw_accelerations(a, w, current, dw);
    for (i = 0; i < CW_JOINTS; ++i) {
      sum_a[i] += weight[stage] * w[i];
      sum_w[i] += weight[stage] * dw[i];
      last_w[i] = w[i];
      last_dw[i] = dw[i];
    }
  }
  for (i = 0; i < CW_JOINTS; ++i) {
    angle[i] += step / 6 * sum_a[i];
    rate[i] += step / 6 * sum_w[i];
  }
}

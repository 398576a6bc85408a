"""What stands before the programs: functions of URScript that do what VAL-II's words mean."""

BEGINNING = """
  # VAL-II counts in a frame that is turned by half a turn about Z against UR's base.
  global v_turn = p[0, 0, 0, 0, 0, 3.141592653589793]
  global v_rad = 0.017453292519943295
  global v_next = 0.0
  global v_always = 1.0
  global v_full_mm = {linear_mm}
  global v_hand_s = {hand}
  def v_here():
    return pose_trans(pose_inv(v_turn), get_forward_kin())
  end
  def v_tool(q):
    return pose_trans(pose_inv(v_turn), get_forward_kin(q))
  end
  def v_share():
    local share = v_always
    if v_next > 0.0:
      share = v_next
    end
    global v_next = 0.0
    return share
  end
"""
MOTIONS = """
  def v_movej(x, r):
    local s = v_share()
    movej(pose_trans(v_turn, x), a={joint_a} * s, v={joint_v} * s, r=r)
    global v_at = x
  end
  def v_movejoints(q, r):
    local s = v_share()
    movej(q, a={joint_a} * s, v={joint_v} * s, r=r)
    global v_at = v_tool(q)
  end
  def v_movel(x, r):
    local s = v_share()
    movel(pose_trans(v_turn, x), a={linear_a} * s, v={linear_v} * s, r=r)
    global v_at = x
  end
  def v_drive(k, by, share, r):
    local q = get_target_joint_positions()
    q[k] = q[k] + v_rad * by
    local kept = v_next
    global v_next = share
    v_movejoints(q, r)
    global v_next = kept
  end
"""
FUNCTIONS = """
  def v_shift(x, y, z):
    return p[x / 1000.0, y / 1000.0, z / 1000.0, 0, 0, 0]
  end
  def v_trans(x, y, z, o, a, t):
    local turned = pose_trans(p[0, 0, 0, 0, 0, v_rad * o], p[0, 0, 0, 0, v_rad * a, 0])
    return pose_trans(v_shift(x, y, z), pose_trans(turned, p[0, 0, 0, 0, 0, v_rad * t]))
  end
  def v_base(x, y, z, o):
    local was = v_turn
    local moved = v_trans(x, y, z, o, 0.0, 0.0)
    global v_turn = pose_trans(p[0, 0, 0, 0, 0, 3.141592653589793], pose_inv(moved))
    global v_at = pose_trans(pose_inv(v_turn), pose_trans(was, v_at))
  end
  def v_frame(a, b, c, d):
    # X from a to b, Y towards c, the origin at d: its three angles about Z, Y and Z
    local xx = b[0] - a[0]
    local xy = b[1] - a[1]
    local xz = b[2] - a[2]
    local zx = xy * (c[2] - a[2]) - xz * (c[1] - a[1])
    local zy = xz * (c[0] - a[0]) - xx * (c[2] - a[2])
    local zz = xx * (c[1] - a[1]) - xy * (c[0] - a[0])
    local flat = sqrt(zx * zx + zy * zy)
    local length = sqrt(flat * flat + zz * zz)
    local first = 0.0
    local third = atan2(xy, xx)
    if flat > 0.000000001 * length:
      first = atan2(zy, zx)
      third = atan2((zx * xy - zy * xx) / length, (-xz))
    elif zz < 0.0:
      third = atan2(xy, (-xx))
    end
    local at = v_shift(1000.0 * d[0], 1000.0 * d[1], 1000.0 * d[2])
    local tilted = pose_trans(p[0, 0, 0, 0, 0, first], p[0, 0, 0, 0, atan2(flat, zz), 0])
    return pose_trans(at, pose_trans(tilted, p[0, 0, 0, 0, 0, third]))
  end
  def v_bit(x, w):
    local n = v_int(x / w)
    return (n - 2.0 * v_int(n / 2.0)) > 0.5
  end
  def v_part(x, k):
    return x[k]
  end
  def v_distance(x, y):
    local a = (x[0] - y[0]) * (x[0] - y[0]) + (x[1] - y[1]) * (x[1] - y[1])
    return 1000.0 * sqrt(a + (x[2] - y[2]) * (x[2] - y[2]))
  end
  def v_real(b):
    if b:
      return -1.0
    end
    return 0.0
  end
  def v_int(x):
    if x < 0.0:
      return ceil(x) + 0.0
    end
    return floor(x) + 0.0
  end
  def v_index(x):
    return floor(x + 0.5)
  end
  def v_sign(x):
    if x < 0.0:
      return -1.0
    end
    return 1.0
  end
  def v_max(x, y):
    if x > y:
      return x
    end
    return y
  end
  def v_hand(open, close):
    set_standard_digital_out({hand_close}, close)
    set_standard_digital_out({hand_open}, open)
  end
"""
CLOCK = """
  global v_start = time()
  def v_clock():
    local t = time()
    return (t.sec - v_start.sec) + ((t.nanosec - v_start.nanosec) / 1000000000.0)
  end
"""

// Moves the eye when the device is tilted, as if the eye stayed in place while the display turned. R = Rz(alpha) Rx(beta)
// Ry(gamma), with the three angles of the sensor, rotates vectors from the device's frame (x right, y up, z out of the screen)
// to the world. R_0 is the initial rotation. A direction e to the eye in the initial frame of the device becomes R^T R_0 e in
// the current frame.

type Vector = [number, number, number];
type Matrix = [Vector, Vector, Vector];

export interface Turn {
  alpha: number;
  beta: number;
  gamma: number;
}

/** Time to wait for the sensor's first event. */
const kWaitMs = 2000;
const kDegree = Math.PI / 180;

function rotation({ alpha, beta, gamma }: Turn): Matrix {
  const [ca, cb, cg] = [alpha, beta, gamma].map((angle) => Math.cos(angle * kDegree));
  const [sa, sb, sg] = [alpha, beta, gamma].map((angle) => Math.sin(angle * kDegree));
  return [
    [ca * cg - sa * sb * sg, -sa * cb, ca * sg + sa * sb * cg],
    [sa * cg + ca * sb * sg, ca * cb, sa * sg - ca * sb * cg],
    [-cb * sg, sb, cb * cg],
  ];
}

const times = (m: Matrix, v: Vector): Vector => m.map((row) => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]) as Vector;
const timesTransposed = (m: Matrix, v: Vector): Vector => [0, 1, 2].map((i) => m[0][i] * v[0] + m[1][i] * v[1] + m[2][i] * v[2]) as Vector;

/** Rotates a vector from the device's frame to the screen's. degrees: rotation of the screen in the device. */
function turned([x, y, z]: Vector, degrees: number): Vector {
  const [c, s] = [Math.cos(degrees * kDegree), Math.sin(degrees * kDegree)];
  return [x * c - y * s, x * s + y * c, z];
}

/** Returns the slopes of the eye after the device has turned; null if the eye is behind the screen. from, to: rotations of
 *  the device. slopes: the slopes at `from`. */
export function slopesAfter(from: Turn, to: Turn, slopes: [number, number], screenDegrees = 0): [number, number] | null {
  const inDevice = turned([slopes[0], slopes[1], 1], -screenDegrees);
  const [x, y, z] = turned(timesTransposed(rotation(to), times(rotation(from), inDevice)), screenDegrees);
  return z > 0.05 ? [x / z, y / z] : null;
}

type WithPermission = { requestPermission?: () => Promise<"granted" | "denied"> };

/** isThere: whether there is a sensor, or the browser may be asked for permission to use one. */
export class Tilt {
  isThere = false;
  isOn = false;
  private from: { turn: Turn; slopes: [number, number] } | null = null;

  constructor(
    private readonly slopes: () => [number, number],
    private readonly move: (slopes: [number, number]) => void,
    private readonly changed: () => void,
    private readonly notify: (text: string) => void,
  ) {
    // Devices without the sensor send one event without values.
    window.addEventListener("deviceorientation", (event) => this.take(event));
    // Browsers that ask for permission do not reveal whether there is a sensor. Most touch devices have one.
    if (typeof DeviceOrientationEvent !== "undefined") this.isThere = "requestPermission" in DeviceOrientationEvent && navigator.maxTouchPoints > 0;
  }

  async toggle(): Promise<void> {
    if (!this.isOn && !(await this.mayRead())) return this.notify("The browser does not let this page read the device's orientation.");
    this.notify("");
    this.isOn = !this.isOn;
    this.from = null;
    this.changed();
    window.setTimeout(() => this.giveUpWithoutSensor(), kWaitMs);
  }

  private giveUpWithoutSensor(): void {
    if (!this.isOn || this.from) return;
    this.isOn = this.isThere = false;
    this.notify("This device does not report its orientation.");
    this.changed();
  }

  private async mayRead(): Promise<boolean> {
    const { requestPermission } = DeviceOrientationEvent as unknown as WithPermission;
    try {
      return !requestPermission || (await requestPermission.call(DeviceOrientationEvent)) === "granted";
    } catch {
      return false;
    }
  }

  private take({ alpha, beta, gamma }: DeviceOrientationEvent): void {
    if (beta === null || gamma === null) return;
    const turn = { alpha: alpha ?? 0, beta, gamma };
    if (!this.isThere) {
      this.isThere = true;
      this.changed();
    }
    if (!this.isOn) return;
    this.from ??= { turn, slopes: this.slopes() };
    const slopes = slopesAfter(this.from.turn, turn, this.from.slopes, screen.orientation?.angle ?? 0);
    if (slopes) this.move(slopes);
  }
}

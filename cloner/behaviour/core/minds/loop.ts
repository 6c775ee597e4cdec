// The agents' loop as the source prints it: update the scene; all perceive and select; then all execute.

import { STEP_S, f, i, setF, setI, steps } from "../memory";
import { GUIDED, endOrders } from "./orders";
import { change } from "./goal_changing";
import { execute } from "./executing";
import { oneSpeed } from "./flocking";
import { follow } from "./following";
import { perceive } from "./perceiving";
import { repel } from "./repulsion";
import { order, react, timed } from "./rules";
import { visit } from "./visiting";

/** Minds work at every second step, feet at each. */
const MIND_STEPS: i32 = 2;
/** Guides' orders that wait for the next step. */
const MOST: i32 = 256;
const waiting = memory.data(MOST * 20);
const seconds = memory.data(MOST * 8);
export let ordered: i32 = 0;
export function setOrdered(count: i32): void { ordered = count; }

/** Let .05 s of a scenario pass. */
export function live(): void {
  const step = steps, now = <f64>step * STEP_S;
  timed(step, now);
  endOrders(now);
  for (let k = 0; k < ordered; k++) {
    const row = 5 * k;
    order(GUIDED, i(waiting, row), i(waiting, row + 1), i(waiting, row + 2), i(waiting, row + 3), i(waiting, row + 4),
      f(seconds, k), step, now);
  }
  ordered = 0;
  if (step % MIND_STEPS == 0) {
    perceive(step, now);
    react(step, now);
    change(now);
    follow(now);
    visit(now);
    oneSpeed();
    repel(now);
  }
  execute(step);
}

/** Give an order from outside, above reactions and script, for the next step; false when too many wait. */
export function guide(verb: i32, who: i32, whose: i32, what: i32, many: i32, lasts: f64): bool {
  if (ordered == MOST) return false;
  const row = 5 * ordered;
  setI(waiting, row, verb);
  setI(waiting, row + 1, who);
  setI(waiting, row + 2, whose);
  setI(waiting, row + 3, what);
  setI(waiting, row + 4, many);
  setF(seconds, ordered++, lasts);
  return true;
}

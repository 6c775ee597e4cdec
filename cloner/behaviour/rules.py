"""Events and reactions: what lets a rule act, and what its actions order on which level."""

from __future__ import annotations

import numpy as np

from cloner.behaviour.channels import GUIDED, REACTION, SCRIPT
from cloner.behaviour.dice import Indices
from cloner.behaviour.model import Action, Rule, When, Who
from cloner.behaviour.perceiving import Seen, sees_anybody
from cloner.behaviour.together.attraction import attract
from cloner.behaviour.together.splitting import split
from cloner.behaviour.world import DONE, WALKING, World

#: How much faster than their own walk people run.
RUN = 1.35


def timed(world: World) -> None:
    """Let the rules of the clock act, withdraw what is over, and obey the guide: the scene's update."""
    for number, rule in enumerate(world.scenario.rules):
        if rule.when.kind == "at" and number not in world.fired and world.time_s >= rule.when.seconds:
            world.fired.add(number)
            _act(world, rule, SCRIPT, [])
    over = [one for one in world.expiring if one[0] <= world.time_s]
    world.expiring = [one for one in world.expiring if one[0] > world.time_s]
    for _, level, who, channels in over:
        world.orders.withdraw(level, who, channels)
    ordered, world.guided = world.guided, []
    for action in ordered:
        apply(world, action, GUIDED, [])


def react(world: World, seen: Seen) -> None:
    """Let each rule act for the groups that meet its condition for the first time."""
    events, world.events = world.events, set()
    for number, rule in enumerate(world.scenario.rules):
        if rule.when.kind == "at":
            continue
        if rule.when.kind == "event":
            if rule.when.what in events:
                _act(world, rule, REACTION, [])
            continue
        bands = [k for k in _bands(world, rule.when.who) if number not in world.bands[k].acted]
        they = [k for k in bands if _met(world, rule.when, k, seen)]
        for k in they:
            world.bands[k].acted.add(number)
        if they:
            _act(world, rule, REACTION, they)


def _act(world: World, rule: Rule, level: int, they: list[int]) -> None:
    for action in rule.actions:
        apply(world, action, level, they)


def _bands(world: World, who: Who) -> list[int]:
    """Return the groups that are meant."""
    if who.kind != "name":
        return list(range(len(world.bands)))
    homes = [one.name for one in world.scenario.groups]
    home = homes.index(who.name) if who.name in homes else -1
    return [k for k, band in enumerate(world.bands) if band.home == home]


def _met(world: World, when: When, number: int, seen: Seen) -> bool:
    """Return whether a group meets a condition, through its leader."""
    leader = world.bands[number].leader
    if not world.bodies.present[leader]:
        return False
    if when.kind == "sees":
        things = [one.name for one in world.scenario.things]
        if when.what in things:
            k = things.index(when.what)
            return bool(seen.things[number, k] and (world.awake[k] or not when.awake))
        return sees_anybody(world, leader, world.of_home([g.name for g in world.scenario.groups].index(when.what)))
    if when.kind == "reaches":
        return bool(world.bodies.settled[leader]) and world.places[int(seen.goal[leader])].name == when.what \
            if seen.goal[leader] >= 0 else False  # fmt: skip
    feeling = [one.name for one in world.scenario.emotions].index(when.what)
    if when.kind == "is":
        return bool(seen.emotion[leader] == feeling)
    others = np.flatnonzero((seen.emotion == feeling) & world.bodies.present)
    return bool(len(others)) and sees_anybody(world, leader, others)


def people_of(world: World, who: Who, they: list[int]) -> Indices:
    """Return the people that are meant."""
    bands = they if who.kind == "they" else _bands(world, who)
    return np.flatnonzero(np.isin(world.people.band, bands) & world.bodies.present)


def apply(world: World, action: Action, level: int, they: list[int]) -> None:
    """Order what an action says, on a level."""
    if action.verb in {"awaken", "sleep"}:
        names = [one.name for one in world.scenario.things]
        world.awake[names.index(action.who.name)] = action.verb == "awaken"
        world.say(f"{action.who.name} {'awakens' if action.verb == 'awaken' else 'sleeps'}")
    elif action.verb == "event":
        world.events.add(str(action.what))
        world.say(f"event {action.what}")
    elif action.verb == "clear":
        world.cleared.append((_place(world, action.what), world.time_s + action.seconds if action.seconds else np.inf))
    elif action.verb == "split":
        for number in _bands(world, action.who):
            split(world, number, action.count)
    else:
        who = people_of(world, action.who, they)
        if len(who):
            _order(world, action, level, who)


def _order(world: World, action: Action, level: int, who: Indices) -> None:
    """Order people something."""
    people, orders, verb = world.people, world.orders, action.verb
    channels: tuple[str, ...] = ()
    if verb == "become":
        people.emotion[who] = [one.name for one in world.scenario.emotions].index(action.what)
        people.value[who] = np.maximum(people.value[who], 0.8)
        return
    if verb in {"go", "run", "leave"}:
        _send(world, _place(world, action.what), level, who)
        people.leaving[who] = verb == "leave"
        if verb == "run":
            speeds = np.array([one.speed for one in world.scenario.emotions])
            orders.give(level, "speed", who, RUN * speeds[people.emotion[who]] * people.pace[who])
    elif verb == "gather":
        attract(world, level, who, _place(world, action.what), action.seconds)
    elif verb == "follow":
        _follow(world, action, who)
    elif verb == "look":
        orders.give(level, "gaze", who, [one.name for one in world.scenario.things].index(action.what))
        channels = ("gaze",)
    elif verb == "act":
        if action.what not in world.acts:
            world.acts.append(str(action.what))
        orders.give(level, "posture", who, world.acts.index(action.what))
        channels = ("posture",)
    elif verb in {"ignore", "heed"}:
        orders.give(level, "avoidance", who, int(verb == "heed"))
        channels = ("avoidance",)
    elif verb == "free":
        for one in range(REACTION, level + 1):
            orders.withdraw(one, who)
    if channels and action.seconds:
        world.expiring.append((world.time_s + action.seconds, level, who.copy(), channels))


def _send(world: World, place: int, level: int, who: Indices) -> None:
    """Send people to a place: as script in place of what their groups wanted to visit, else by an order above that."""
    for number in np.unique(world.people.band[who]):
        world.bands[number].knows.add(place)
        if level == SCRIPT:
            world.bands[number].visits, world.bands[number].follows = [place], -1
    if level == SCRIPT:
        world.orders.withdraw(SCRIPT, who, ("goal", "posture", "gaze"))
        world.people.visit[who], world.people.phase[who] = -1, DONE
    else:
        world.orders.give(level, "goal", who, place)


def _follow(world: World, action: Action, who: Indices) -> None:
    home = [one.name for one in world.scenario.groups].index(action.what)
    for number in np.unique(world.people.band[who]):
        band = world.bands[number]
        if band.home != home:
            band.follows, band.follows_at_times = home, False
            band.follows_until = world.time_s + action.seconds if action.seconds else np.inf
    world.people.phase[who] = WALKING


def _place(world: World, name: str) -> int:
    return next(k for k, one in enumerate(world.places) if one.name == name)

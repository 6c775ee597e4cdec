"""Grammar of the scenario language (lark, LALR), and names of its tokens in errors."""

from __future__ import annotations

from typing import Final

GRAMMAR: Final = r"""
start: _NL? [statement (_NL statement)* _NL?]
?statement: scene | floor | obstacle | point | thing | emotion | crowd | group | at_rule | when_rule
scene: "scene" STRING
?floor: "floor" xy "to" xy -> floor_box
     | "floor" "through" xy (";" xy)+ -> floor_through
?obstacle: "obstacle" NAME "at" xy "size" size -> obstacle_box
        | "obstacle" NAME "through" xy (";" xy)+ -> obstacle_through
point: "point" NAME "at" xy point_part*
?point_part: "region" size -> region
           | "act" NAME "for" NUMBER "s" -> act
           | "one" "at" "a" "time" -> one_at_a_time
           | "shared" -> shared
           | "holds" INT -> holds
           | "look" "at" NAME -> look_at
thing: ("statue" | "thing") NAME "at" xy
emotion: "emotion" NAME "speed" NUMBER ["walk" NAME] ["acts" NAME ("and" NAME)*]
crowd: "crowd" INT NAME [_COLON group_part (_COMMA group_part)*]
group: "group" NAME _COLON INT "people" (_COMMA group_part)*
?group_part: "leader" NAME -> leader
           | "emotion" NAME [NUMBER "%"] -> feeling
           | "visits" NAME (">" NAME)* [AGAIN] -> visits
           | "knows" NAME ("and" NAME)* -> knows
           | "memory" INT -> memory
           | "follows" NAME ["for" NUMBER "s"] -> follows
           | "follows" NAME "at" "times" -> follows_at_times
           | "likes" NAME NUMBER -> likes
           | "flocking" -> flocking
           | "adapts" "to" "space" -> adapts
           | "wanders" -> wanders
           | "from" "outside" -> outside
           | "starts" "at" NAME -> starts_at
at_rule: "at" NUMBER "s" _COLON actions
when_rule: "when" trigger _COLON actions
?trigger: "event" NAME -> on_event
       | who ("sees" | "see") NAME [AWAKE] -> on_sees
       | who ("sees" | "see") ("anybody" | "somebody") NAME -> on_sees_feeling
       | who ("is" | "are") NAME -> on_is
       | who ("reaches" | "reach") NAME -> on_reaches
actions: action (_COMMA action)*
?action: who ("becomes" | "become") NAME -> become
       | who ("goes" | "go") "to" NAME -> go
       | who ("runs" | "run") "to" NAME -> run
       | who ("leaves" | "leave") "by" NAME -> leave
       | who ("gathers" | "gather") "at" NAME ["for" NUMBER "s"] -> gather
       | who ("follows" | "follow") NAME ["for" NUMBER "s"] -> follow
       | who ("looks" | "look") "at" NAME ["for" NUMBER "s"] -> look
       | who ("does" | "do") NAME ["for" NUMBER "s"] -> do
       | who ("is" | "are") "free" -> free
       | who ("ignores" | "ignore") "others" -> ignore
       | who ("heeds" | "heed") "others" -> heed
       | who "awakens" -> awaken
       | who "sleeps" -> sleep
       | "clear" NAME ["for" NUMBER "s"] -> clear
       | "split" NAME "into" INT -> split
       | "event" NAME -> event
?who: ("everybody" | "anybody") -> everybody
   | "they" -> they
   | ("group" | "crowd" | "statue" | "thing")? NAME -> named
xy: NUMBER _COMMA NUMBER
size: NUMBER "x" NUMBER
AGAIN: "again"
AWAKE: "awake"
NUMBER: /[-+]?\d{1,9}(\.\d{1,9})?|[-+]?\.\d{1,9}/
INT: /\d{1,9}/
NAME: /[^\W\d]\w*/
STRING: /"[^"\n]*"/
_NL: /([ \t]*(#[^\n]*)?\r?\n)+/
_COMMA: /,([ \t]*(#[^\n]*)?\r?\n)*/
_COLON: /:([ \t]*(#[^\n]*)?\r?\n)*/
%ignore /[ \t]+/
%ignore /#[^\n]*/
"""

#: What tokens are called where one of them was expected.
CALLED: Final = {
    "NAME": "a name",
    "NUMBER": "a number",
    "INT": "a whole number",
    "STRING": "a file's name in quotes",
    "_NL": "a new line",
    "$END": "the end",
    "_COMMA": "a comma",
    "_COLON": "a colon",
    "SEMICOLON": "a semicolon",
    "MORETHAN": "'>'",
    "PERCENT": "'%'",
}

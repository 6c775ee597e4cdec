"""The page: one self-contained file in the visitor's language."""

from __future__ import annotations

import base64
import hashlib
from html import escape
from typing import Final

from cloner.booth.phone.parcel import SIDES

WORDS: Final = {
    "en": ("Your clone", "Drag to turn", "Film", "Picture", "3-D file (GLB)", "This link works until {time}."),
    "de": ("Ihr Klon", "Zum Drehen ziehen", "Film", "Bild", "3-D-Datei (GLB)", "Dieser Link gilt bis {time}."),
    "fr": ("Votre clone", "Glissez pour tourner", "Film", "Image", "Fichier 3D (GLB)", "Lien valable jusqu’au {time}."),
    "tr": ("Klonunuz", "Döndürmek için sürükleyin", "Film", "Resim", "3B dosya (GLB)", "Bağlantının sonu: {time}."),
}
_STYLE: Final = """
body{margin:0;font:17px/1.4 system-ui,sans-serif;background:#eef0f3;color:#1c2430;text-align:center}
h1{font-size:1.3em;margin:.7em 0 .2em}
#turn{width:100%;max-width:480px;aspect-ratio:2/3;touch-action:pan-y;border-radius:12px;background:#eceef1}
a{display:block;max-width:440px;margin:.6em auto;padding:.8em;border-radius:10px;background:#1f6feb;color:#fff;
text-decoration:none;font-weight:600}
p{color:#5a6472;margin:.4em 1em 1em}
"""
_SCRIPT: Final = """
const N=%d,seen=document.getElementById('turn'),all=[];let at=0,from=null,base=0,own=true;
for(let n=0;n<N;n++){const one=new Image();one.src='side_'+String(n).padStart(2,'0')+'.jpg';all.push(one)}
function show(n){at=((n%%N)+N)%%N;seen.src=all[at].src}
const calm=matchMedia('(prefers-reduced-motion: reduce)').matches;
if(!calm)setInterval(()=>{if(own&&from===null)show(at+1)},150);
seen.addEventListener('pointerdown',e=>{own=false;from=e.clientX;base=at;seen.setPointerCapture(e.pointerId)});
seen.addEventListener('pointermove',e=>{if(from!==null)show(base+Math.round((e.clientX-from)/14))});
for(const name of ['pointerup','pointercancel'])seen.addEventListener(name,()=>{from=null});
seen.addEventListener('keydown',e=>{if(e.key==='ArrowLeft'){own=false;show(at-1)}if(e.key==='ArrowRight'){own=false;
show(at+1)}});
"""


def page(language: str, until: str) -> bytes:
    """Return the HTML page of a visitor; it contains no name.

    Parameters
    ----------
    language : str
        One of the window's.
    until : str
        When the link expires, as it is read.
    """
    title, drag, film, picture, glb, lasts = (escape(one) for one in WORDS.get(language, WORDS["en"]))
    links = "".join(
        f'<a href="{file}" download="clone{file[file.rindex(".") :]}">{text}</a>'
        for file, text in (("film.webp", film), ("picture.jpg", picture), ("clone.glb", glb))
    )
    return (
        f'<!doctype html><html lang="{escape(language)}"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width,initial-scale=1"><meta name="robots" content="noindex">'
        '<link rel="icon" href="side_00.jpg">'  # else a browser asks for one that is not there: a wrong try
        f"<title>{title}</title><style>{_STYLE}</style></head><body><h1>{title}</h1>"
        f'<img id="turn" tabindex="0" src="side_00.jpg" alt="{title}" draggable="false"><p>{drag}</p>{links}'
        f"<p>{lasts.replace('{time}', escape(until))}</p><script>{_script()}</script></body></html>"
    ).encode()


def policy() -> str:
    """Return the page's content security policy: its own pictures, one script and one style, nothing else."""
    script, style = (base64.b64encode(hashlib.sha256(one.encode()).digest()).decode() for one in (_script(), _STYLE))
    return (
        f"default-src 'none'; img-src 'self'; script-src 'sha256-{script}'; style-src 'sha256-{style}'; "
        "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    )


def _script() -> str:
    return _SCRIPT % SIDES

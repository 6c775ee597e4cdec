"""An e-mail draft to the visitor, as a file that mail programs open; this program sends nothing."""

from __future__ import annotations

from email.message import EmailMessage
from email.policy import SMTP


def email_draft(subject: str, text: str, picture_jpeg: bytes) -> bytes:
    """Return an unsent message (.eml) with a picture attached; the recipient is entered in the mail program.

    Parameters
    ----------
    subject, text : str
        Plain; line ends in the subject are taken out.
    picture_jpeg : bytes
    """
    message = EmailMessage(policy=SMTP)
    message["X-Unsent"] = "1"  # by this mail programs open it for writing
    message["Subject"] = " ".join(subject.split())
    message.set_content(text)
    message.add_attachment(picture_jpeg, maintype="image", subtype="jpeg", filename="clone.jpg")
    return message.as_bytes()

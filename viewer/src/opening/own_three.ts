/** This part of the page has a copy of three of its own, which would remark upon the other one. */
delete (globalThis as { __THREE__?: string }).__THREE__;

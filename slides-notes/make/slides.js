// Keys of the slides: on, back, first and last; N shows the speaker notes; S opens a second window that follows
// this one, for a projector.
"use strict";
const slides = [...document.querySelectorAll(".slide")];
const forward = ["ArrowRight", "ArrowDown", "PageDown", " "];
const back = ["ArrowLeft", "ArrowUp", "PageUp"];
let other = window.opener;

// The slide that fills the most of the window.
function current() {
    const middle = window.innerHeight / 2;
    return slides.findIndex(slide => slide.getBoundingClientRect().bottom > middle);
}
function show(n) {
    slides[Math.max(0, Math.min(slides.length - 1, n))].scrollIntoView({behavior: "instant"});
}
// show(), in the other window as well.
function go(n) {
    show(n);
    if (other) other.postMessage({slide: n}, "*");
}
window.addEventListener("message", event => {
    if (event.source === other && Number.isInteger(event.data.slide)) show(event.data.slide);
});
document.addEventListener("keydown", event => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const at = current();
    if (forward.includes(event.key)) go(at + 1);
    else if (back.includes(event.key)) go(at - 1);
    else if (event.key === "Home") go(0);
    else if (event.key === "End") go(slides.length - 1);
    else if (event.key === "n") {
        document.documentElement.classList.toggle("speaking");
        show(at);
    } else if (event.key === "s") other = window.open(location.href.split("#")[0], "projector", "popup");
    else return;
    event.preventDefault();
});

// What only a browser can tell of the course's pages: opened one by one in a frame of a given width, as
// tests/suites/notes.sh lists them. Each finding becomes a line of the document.
"use strict";

const frame = document.createElement("iframe");
document.body.append(frame);

// What the document says in the end, a line each.
const said = [];
function tell(job, what) {
    said.push(`fault ${job.width} ${job.page}: ${what}`);
}

// Does the box reach out of the frame? What scrolls by itself is let be.
function tooWide(element, width) {
    for (let box = element; box; box = box.parentElement) {
        const overflow = box.ownerDocument.defaultView.getComputedStyle(box).overflowX;
        if (overflow === "auto" || overflow === "scroll") return false;
    }
    return element.getBoundingClientRect().right > width + 1;
}

function pictures(job, page) {
    for (const image of page.images) {
        if (!image.complete || image.naturalWidth === 0) tell(job, `a picture is missing: ${image.alt}`);
        if (!image.alt) tell(job, `a picture has no text in its place`);
    }
}

// A drawing's words as large as the slide shows them: of 1280 x 720 at least 20 high.
function drawings(job, stage, title) {
    for (const image of stage.querySelectorAll('img[src^="data:image/svg"]')) {
        const sizes = [...atob(image.src.split(",")[1]).matchAll(/font-size="([\d.]+)"/g)].map(found => Number(found[1]));
        const scale = Math.min(image.width / image.naturalWidth, image.height / image.naturalHeight);
        const size = Math.min(...sizes) * scale;
        said.push(`drawing ${size.toFixed(1)} ${job.page}, ${title}: ${image.alt}`);
        if (size < 19.9) tell(job, `${title}: words of ${size.toFixed(1)} in the drawing`);
    }
}

// On a slide of 1280 x 720 nothing is cut off, and no letter is smaller than 24. A figure counts
// as a picture, also where a newer pandoc puts its SVG into the page.
function slides(job, page) {
    const window = page.defaultView;
    page.querySelectorAll(".stage").forEach((stage, n) => {
        const title = `slide ${n + 1}, ${stage.querySelector("h2").textContent}`;
        drawings(job, stage, title);
        const foot = stage.querySelector("footer").getBoundingClientRect().top;
        for (const element of stage.querySelectorAll(".columns *")) {
            if (element.ownerSVGElement) continue;
            const box = element.getBoundingClientRect();
            const column = element.closest(".said, .shown") || stage;
            if (box.bottom > foot + 1 || box.right > column.getBoundingClientRect().right + 1) {
                tell(job, `${title}: <${element.tagName.toLowerCase()}> is cut off`);
                break;
            }
        }
        const letters = page.createTreeWalker(stage, NodeFilter.SHOW_TEXT);
        for (let text = letters.nextNode(); text; text = letters.nextNode()) {
            const parent = text.parentElement;
            // Exponents and indices are smaller than what they belong to.
            if (!text.data.trim() || parent.closest("msub, msup, mfrac, svg")) continue;
            const size = parseFloat(window.getComputedStyle(parent).fontSize);
            if (size < 23.9) {
                tell(job, `${title}: letters of ${size}: ${text.data.trim().slice(0, 30)}`);
                break;
            }
        }
    });
}

function inspect(job) {
    const page = frame.contentDocument;
    pictures(job, page);
    if (job.width === 1280 && page.querySelector(".stage")) slides(job, page);
    if (page.documentElement.scrollWidth > job.width) {
        const guilty = [...page.querySelectorAll("body *")].find(element => tooWide(element, job.width));
        tell(job, `wider than the screen: ${guilty ? guilty.outerHTML.slice(0, 80) : "?"}`);
    }
    said.push(`opened ${job.width} ${job.page}`);
}

// jobs: [{page: address, width: pixels}, ...], written into the document by the suite.
async function run() {
    for (const job of jobs) {
        frame.style = `border: 0; width: ${job.width}px; height: 720px`;
        await new Promise(done => {
            frame.onload = done;
            frame.src = job.page;
        });
        inspect(job);
    }
    document.body.innerHTML = "";
    const list = document.createElement("pre");
    list.textContent = said.join("\n") + "\nend\n";
    document.body.append(list);
}
run();

// Touching the figures of the notes, as a reader does, in frames; what they say becomes lines of the
// document: "NAME:STATE words". tests/suites/notes.sh compares them with what the programs print.
"use strict";

const said = [];

async function open(page, sandbox) {
    const frame = document.createElement("iframe");
    frame.style = "border: 0; width: 1280px; height: 720px";
    if (sandbox) frame.sandbox = "allow-same-origin";  // and no scripts
    await new Promise(done => {
        frame.onload = done;
        frame.src = folder + page;
        document.body.append(frame);
    });
    return frame.contentDocument;
}

// One touchable figure, and what can be done with it.
class Figure {
    constructor(page, name) {
        this.name = name;
        this.window = page.defaultView;
        this.figure = page.querySelector(`figure[data-name="${name}"]`);
        this.live = this.figure?.querySelector(".live");
    }
    words() { return this.figure.querySelector(".said").textContent; }
    key(key, times = 1, shiftKey = false) {
        for (let i = 0; i < times; i++) {
            this.live.dispatchEvent(new this.window.KeyboardEvent("keydown", {key, shiftKey, bubbles: true, cancelable: true}));
        }
    }
    button(text) { [...this.figure.querySelectorAll("button")].find(button => button.textContent === text).click(); }
    // From one point of the drawing to another.
    drag(from, to) {
        const send = (type, [x, y]) => {
            const svg = this.live.querySelector("svg"), box = svg.getBoundingClientRect();
            const scale = box.width / svg.viewBox.baseVal.width;
            svg.querySelector(".drag").dispatchEvent(new this.window.PointerEvent(type,
                {bubbles: true, pointerId: 1, clientX: box.left + scale * x, clientY: box.top + scale * y}));
        };
        // No pointer is down in truth, so none can be captured.
        this.live.setPointerCapture = () => {};
        send("pointerdown", from);
        send("pointermove", to);
        send("pointerup", to);
    }
    isLast() { return /(?:step|Plane) (\d+) of \1(?!\d)/.test(this.words()); }
    // All steps from the first one on.
    tell(state) {
        this.key("Home");
        for (let i = 0; i < 100; i++) {
            for (const line of this.words().split("\n")) said.push(`${this.name}:${state} ${line}`);
            if (this.isLast()) return;
            this.button("Step");
        }
        this.fault("its steps do not end");
    }
    fault(what) { said.push(`fault ${this.name}: ${what}`); }

    // What all of them can.
    async check() {
        this.key("Home");
        const first = this.words(), drawing = this.live.innerHTML;
        this.button("Step");
        if (this.words() === first) this.fault("Step changes no word");
        if (this.live.innerHTML === drawing) this.fault("Step changes nothing in the drawing");
        this.button("Back");
        if (this.words() !== first || this.live.innerHTML !== drawing) this.fault("Back does not undo Step");
        this.button("Run");
        for (let i = 0; i < 600 && !this.isLast(); i++) await new Promise(done => setTimeout(done, 100));
        if (!this.isLast()) this.fault("Run does not come to the end");
        if (!this.live.ariaLabel || this.live.tabIndex !== 0) this.fault("no key reaches it");
        if (this.figure.querySelector("img, :scope > svg").getBoundingClientRect().height > 0) this.fault("the still picture is there, too");
    }
}

async function live(page, name) {
    for (let i = 0; i < 600; i++) {
        const figure = new Figure(page, name);
        if (figure.live) return figure;
        await new Promise(done => setTimeout(done, 100));
    }
    throw new Error(`${name} does not become live`);
}

async function searchTouch(page) {
    const figure = await live(page, "03-search");
    figure.tell("first");
    figure.key("ArrowLeft", 2);
    figure.key("ArrowUp", 2);
    figure.tell("moved");
    figure.drag([240, 288], [120, 208]);
    figure.tell("dragged");
    await figure.check();
}

async function rayTouch(page) {
    const figure = await live(page, "07-search");
    figure.tell("first");
    for (let i = 0; i < 3; i++) figure.key("ArrowRight", 1, true);
    figure.tell("moved");
    // The ray, by a point that it goes through.
    figure.drag([429, 252], [429, 342]);
    figure.tell("dragged");
    await figure.check();
}

async function costTouch(page) {
    const figure = await live(page, "08-cost");
    figure.tell("first");
    await figure.check();
    // Towards a lower plane, by one.
    figure.drag([800, 300], [552, 300]);
    const dragged = figure.words();
    figure.key("ArrowLeft");
    figure.key("ArrowRight");
    if (!dragged.startsWith("Plane 16 ") || figure.words() !== dragged) figure.fault(`dragged to the middle it says: ${dragged}`);
}

async function stillCheck(page, name) {
    const figure = new Figure(await open(page, true), name);
    const picture = figure.figure?.querySelector("img, :scope > svg");
    if (figure.live) figure.fault("is live without JavaScript");
    if (!picture || picture.getBoundingClientRect().height < 100) figure.fault("no still picture without JavaScript");
}

async function run() {
    try {
        await searchTouch(await open("notes-2d.html", false));
        const second = await open("notes-3d.html", false);
        await rayTouch(second);
        await costTouch(second);
        await stillCheck("notes-2d.html", "03-search");
        await stillCheck("notes-3d.html", "07-search");
        await stillCheck("notes-3d.html", "08-cost");
    } catch (error) {
        said.push(`fault ${error}`);
    }
    document.body.innerHTML = "";
    const list = document.createElement("pre");
    list.textContent = "\n" + said.join("\n") + "\nend\n";
    document.body.append(list);
}
run();

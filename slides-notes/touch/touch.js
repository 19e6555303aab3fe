// Figures that can be touched. The program, the course's own C code as WebAssembly (touch.c), draws and
// speaks; this hands on what the reader does, and shows what comes back.
"use strict";

// What a C library asks of its system. There is none: all fails, but messages reach the console.
function systemFor(module, memory) {
    const notThere = 52;  // WASI's ENOSYS
    const calls = {};
    for (const {module: system, name} of WebAssembly.Module.imports(module)) {
        calls[system] ??= {};
        calls[system][name] = () => notThere;
    }
    const system = calls.wasi_snapshot_preview1;
    system.proc_exit = status => { throw new Error(`the program has ended with status ${status}`); };
    system.fd_write = (file, pieces, nPieces, nWritten) => {
        const view = new DataView(memory().buffer);
        let total = 0;
        for (let i = 0; i < nPieces; i++) {
            const length = view.getUint32(pieces + 8 * i + 4, true);
            console.warn(new TextDecoder().decode(new Uint8Array(memory().buffer, view.getUint32(pieces + 8 * i, true), length)));
            total += length;
        }
        view.setUint32(nWritten, total, true);
        return 0;
    };
    return calls;
}

// The program, in memory of its own for each figure.
async function start(module) {
    let program = null;
    const instance = await WebAssembly.instantiate(module, systemFor(module, () => program.memory));
    program = instance.exports;
    program._initialize();
    return program;
}

// The text at an address, zero at its end; null at 0.
function textAt(program, address) {
    if (address === 0) return null;
    const bytes = new Uint8Array(program.memory.buffer, address);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
}

function element(name, properties, ...children) {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
}

// Make the figure live, in the place of its still picture.
function touch(figure, program, number) {
    const what = textAt(program, program.touch_what(number));
    const picture = element("div", {className: "live", tabIndex: 0, role: "application", ariaLabel: what});
    const said = element("p", {className: "said", ariaLive: "polite"});
    let step = program.touch_still_step();
    let running = 0;

    function show() {
        const isNarrow = figure.clientWidth < 600;
        picture.innerHTML = textAt(program, program.touch_draw(step, isNarrow ? 1 : 0));
        const words = textAt(program, program.touch_tell(step));
        if (said.textContent !== words) said.textContent = words;
    }
    // Go to a step; behind the last one it begins anew.
    function go(to) {
        const count = program.touch_count_steps();
        step = to < 0 ? count - 1 : to < count ? to : 0;
        show();
    }
    function isLast() {
        return step === program.touch_count_steps() - 1;
    }
    // Change the state. Where the figure names no step, it stays, and the last one the last.
    function change(how) {
        const wasLast = isLast(), to = how(), count = program.touch_count_steps();
        step = to >= 0 ? to : wasLast ? count - 1 : Math.min(step, count - 1);
        show();
    }
    function stop() {
        clearInterval(running);
        running = 0;
        run.textContent = "Run";
    }
    // A step every while, up to the last one; again it stops.
    function toggleRun() {
        if (running) return stop();
        if (isLast()) go(0);
        run.textContent = "Stop";
        running = setInterval(() => {
            go(step + 1);
            if (isLast()) stop();
        }, 1000);
    }
    function button(text, does) {
        return element("button", {type: "button", textContent: text, onclick: does});
    }
    const back = button("Back", () => { stop(); go(step - 1); });
    const on = button("Step", () => { stop(); go(step + 1); });
    const run = button("Run", toggleRun);

    // Where the pointer is in the drawing.
    function place(event) {
        const svg = picture.firstElementChild, box = svg.getBoundingClientRect();
        const scale = svg.viewBox.baseVal.width / box.width;
        return [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
    }
    function drag(event) {
        change(() => program.touch_drag(...place(event)));
    }
    let dragging = false;
    picture.addEventListener("pointerdown", event => {
        if (!event.target.closest(".drag")) return;
        stop();
        dragging = true;
        picture.setPointerCapture(event.pointerId);
        program.touch_take(...place(event));
        drag(event);
    });
    picture.addEventListener("pointermove", event => { if (dragging) drag(event); });
    for (const end of ["pointerup", "pointercancel"]) {
        picture.addEventListener(end, () => { dragging = false; });
    }

    const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
    const keys = {" ": on, Enter: on, Backspace: back, r: run};
    picture.addEventListener("keydown", event => {
        if (event.ctrlKey || event.altKey || event.metaKey) return;
        if (arrows[event.key]) {
            stop();
            change(() => program.touch_move(...arrows[event.key], event.shiftKey ? 1 : 0));
        } else if (keys[event.key]) keys[event.key].click();
        else if (event.key === "Home") go(0);
        else if (event.key === "End") go(-1);
        else return;
        event.preventDefault();
    });

    const hint = element("span", {className: "hint", textContent: "space, backspace, R"});
    figure.classList.add("touched");
    figure.insertBefore(picture, figure.querySelector("figcaption"));
    picture.after(element("p", {className: "what", textContent: `${what}.`}), element("div", {className: "keys"}, back, on, run, hint), said);
    let width = figure.clientWidth;
    new ResizeObserver(() => {
        if (figure.clientWidth !== width) {
            width = figure.clientWidth;
            show();
        }
    }).observe(figure);
    show();
}

async function touchAll() {
    const module = await WebAssembly.compile(Uint8Array.from(atob(touchProgram), letter => letter.charCodeAt(0)));
    const names = await start(module);
    for (let number = 0; names.touch_name(number) !== 0; number++) {
        const name = textAt(names, names.touch_name(number));
        for (const figure of document.querySelectorAll(`figure[data-name="${name}"]`)) {
            const program = await start(module);
            if (program.touch_open(number) === 0) touch(figure, program, number);
        }
    }
}
touchAll();

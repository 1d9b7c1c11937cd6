"use strict";
(function () {
  const data = JSON.parse(document.getElementById("data").textContent);
  const find = (id) => document.getElementById(id);
  const [scene, left, right, show, zoom, divider] =
    ["scene", "left", "right", "show", "zoom", "divider"].map(find);

  function fill(select, names, chosen) {
    const before = names.indexOf(select.value);
    select.replaceChildren(...names.map((name, index) => new Option(name, String(index))));
    select.value = String(chosen === undefined ? Math.max(before, 0) : chosen);
  }

  function chosen(select) {
    return data.scenes[Number(scene.value)].shown[Number(select.value)];
  }

  // Another scene keeps the methods where it has them.
  function chooseScene() {
    const names = data.scenes[Number(scene.value)].shown.map((each) => each.method);
    [[left, 0], [right, 1]].forEach(([select, otherwise]) => {
      const name = select.selectedOptions.length ? select.selectedOptions[0].textContent : "";
      const index = names.indexOf(name);
      fill(select, names, index >= 0 ? index : Math.min(otherwise, names.length - 1));
    });
    draw();
  }

  function draw() {
    [[left, "left"], [right, "right"]].forEach(([select, side]) => {
      const each = chosen(select);
      const image = find(side + "-picture");
      const isDifference = show.value === "difference";
      const source = isDifference ? each.difference : each.picture;
      image.alt = (isDifference ? "difference of " : "picture by ") + each.method;
      image.style.visibility = source ? "visible" : "hidden";
      image.onload = resize;
      image.src = source || each.picture;
      find(side + "-note").textContent = each.method + ": " + each.note;
    });
    find("amplified").textContent = show.value === "difference" ? data.amplified : "";
    move();
  }

  function resize() {
    ["left-picture", "right-picture"].forEach((id) => {
      const image = find(id);
      image.width = image.naturalWidth * Number(zoom.value);
      image.height = image.naturalHeight * Number(zoom.value);
    });
  }

  function move() {
    const percent = Number(divider.value);
    find("left-picture").style.clipPath = "inset(0 " + (100 - percent) + "% 0 0)";
    find("line").style.left = percent + "%";
    divider.setAttribute("aria-valuetext",
      percent + " % " + chosen(left).method + ", " + (100 - percent) + " % " + chosen(right).method);
  }

  function drag(event) {
    if (event.buttons === 1 || event.type === "pointerdown") {
      const box = find("stage").getBoundingClientRect();
      divider.value = String(Math.round(100 * (event.clientX - box.left) / box.width));
      move();
    }
  }

  if (!data.scenes.length) {
    find("viewer").replaceChildren("There are no pictures.");
    find("controls").hidden = true;
    return;
  }
  fill(scene, data.scenes.map((each) => each.name), 0);
  find("scene-choice").hidden = data.scenes.length < 2;
  scene.addEventListener("change", chooseScene);
  [left, right, show].forEach((select) => select.addEventListener("change", draw));
  zoom.addEventListener("change", resize);
  divider.addEventListener("input", move);
  find("stage").addEventListener("pointerdown", drag);
  find("stage").addEventListener("pointermove", drag);
  find("stage").addEventListener("dragstart", (event) => event.preventDefault());
  find("controls").addEventListener("submit", (event) => event.preventDefault());
  chooseScene();
  // Small pictures are shown larger at first.
  const first = new Image();
  first.onload = () => {
    const factors = [8, 4, 2, 1];
    zoom.value = String(factors.find((factor) => factor * first.naturalWidth <= 700) || 1);
    resize();
  };
  first.src = chosen(left).picture;
})();

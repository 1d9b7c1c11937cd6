# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""A page in headless Chromium, by Selenium and the system's driver."""

import base64
import contextlib
import importlib.util
import shutil

DRIVER = "chromedriver"
BROWSER = "chromium"
SIZE = (1100, 1000)


def missing():
    """What is missing to open a page, str; empty when nothing is."""
    found = [name for name in (DRIVER, BROWSER) if not shutil.which(name)]
    if importlib.util.find_spec("selenium") is None:
        found.append("Python's selenium")
    return "no %s (Debian: chromium chromium-driver python3-selenium)" % ", ".join(found) if found else ""


@contextlib.contextmanager
def page(path, scheme="light"):
    """A selenium WebDriver that shows a file, closed at the end; scheme: "light" or "dark"."""
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which(BROWSER)
    # As root, and in containers, Chromium has neither a sandbox nor shared memory.
    for flag in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu",
                 "--hide-scrollbars", "--window-size=%d,%d" % SIZE):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(service=Service(shutil.which(DRIVER)), options=options)
    try:
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "features": [{"name": "prefers-color-scheme", "value": scheme}]})
        driver.get("file://" + path)
        yield driver
    finally:
        driver.quit()


def complaints(driver):
    """What the browser's console says, list of str: errors of scripts, and what the page was not allowed."""
    return [entry["message"] for entry in driver.get_log("browser")]


def screenshot(driver, path):
    """Writes what the page shows to a PNG file, all of its height."""
    shot = driver.execute_cdp_cmd("Page.captureScreenshot", {"captureBeyondViewport": True, "clip": {
        "x": 0, "y": 0, "width": SIZE[0], "scale": 1,
        "height": driver.execute_script("return document.documentElement.scrollHeight")}})
    with open(path, "wb") as file:
        file.write(base64.b64decode(shot["data"]))

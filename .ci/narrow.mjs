// Opens pages 390 pixels wide, as on a telephone, and fails if one scrolls sideways, if a table or formula is wider than the page
// without scrolling within itself, if lines of a list of contents overlap, or if text of a plot is smaller than 11 pixels.
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const { chromium } = createRequire(`${process.cwd()}/`)('playwright-core');
const WIDTH = 390;
const LEAST_TEXT = 11;
const [browserPath, ...pages] = process.argv.slice(2);
const browser = await chromium.launch({ executablePath: browserPath, args: ['--no-sandbox'] });
const page = await browser.newPage({ viewport: { width: WIDTH, height: 844 }, deviceScaleFactor: 1 });
let faults = 0;
for (const path of pages) {
    await page.goto(pathToFileURL(path).href);
    const found = await page.evaluate(leastText => {
        const all = selector => [...document.querySelectorAll(selector)];
        const faults = [];
        const wide = document.documentElement.scrollWidth;
        if (wide > innerWidth) faults.push(`the page is ${wide} pixels wide`);
        for (const box of all('table, math, img, svg[role=img]')) {
            const right = box.getBoundingClientRect().right;
            const scrolls = box.closest('.wide, .formula');
            if (right > innerWidth + 1 && !scrolls) faults.push(`${box.tagName} ends at ${Math.round(right)} pixels`);
            if (scrolls && scrolls.scrollWidth > scrolls.clientWidth + 1 && scrolls.tabIndex < 0) {
                faults.push(`${box.tagName} scrolls, but not by keyboard`);
            }
        }
        const links = all('nav a').map(link => [link.textContent, [...link.getClientRects()]]);
        for (const [at, [name, rects]] of links.entries()) {
            for (const [other, others] of links.slice(at + 1)) {
                const meet = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1;
                if (rects.some(a => others.some(b => meet(a, b)))) faults.push(`contents: “${name}” overlaps “${other}”`);
            }
        }
        for (const drawing of all('svg[role=img]')) {
            const scale = drawing.getBoundingClientRect().width / drawing.viewBox.baseVal.width;
            const sizes = [...drawing.querySelectorAll('text')].map(text => scale * parseFloat(getComputedStyle(text).fontSize));
            const least = Math.min(...sizes);
            if (least < leastText) faults.push(`text of a plot has ${least.toFixed(1)} pixels`);
        }
        return faults;
    }, LEAST_TEXT);
    found.forEach(fault => console.error(`${path}: ${fault}`));
    faults += found.length;
}
await browser.close();
console.log(`${pages.length} pages, ${faults} faults`);
process.exit(faults > 0 ? 1 : 0);

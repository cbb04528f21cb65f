/* The looks of the page: light, dark, printed; no script, no font and no picture from elsewhere. */
#include "report/page.h"

const char *const page_style[] = {
    ":root{color-scheme:light dark;--paper:#fff;--ink:#17202a;--soft:#596675;--line:#dde2e8;"
    "--panel:#f5f7f9;\n",
    "--left:#1b6ec2;--right:#c4570a;--good:#177245;--warn:#9a5b00;--bad:#b3261e;"
    "--band:#bfe0cc;\n",
    "--knot:#7a3fa8;--p0:#d6e4f5;--p1:#e4dcf3;--p2:#d8ecdf;--p3:#f6e6cf;--p4:#f3d9de;--p5:#d9ecef}"
    "\n",
    "@media (prefers-color-scheme:dark){:root{--paper:#12161b;--ink:#e6eaef;--soft:#9aa7b5;"
    "--line:#2c343e;\n",
    "--panel:#1a2027;--left:#6db3f5;--right:#f2a05c;--good:#63c794;--warn:#e0a94f;"
    "--bad:#f28b82;--band:#244f38;\n",
    "--knot:#c49af0;--p0:#22364d;--p1:#352b4d;--p2:#1f4030;--p3:#4a391d;--p4:#4c2731;--p5:#1d4148}}"
    "\n",
    "*{box-sizing:border-box}\n",
    "body{margin:0;background:var(--paper);color:var(--ink);"
    "font:16px/1.5 system-ui,'Segoe UI',Roboto,\n",
    "'Helvetica Neue',Arial,sans-serif;font-variant-numeric:tabular-nums}\n",
    "main,header,footer{max-width:62rem;margin:0 auto;padding:0 1.5rem}\n",
    "header{padding-top:2.5rem}"
    "h1{font-size:1.9rem;line-height:1.2;margin:0 0 .3rem;letter-spacing:-.01em}\n",
    "header p{margin:.1rem 0;color:var(--soft)}\n",
    "h2{font-size:1.25rem;margin:2.6rem 0 .8rem;padding-top:1rem;"
    "border-top:1px solid var(--line)}\n",
    "a{color:var(--left)}bdi,code{overflow-wrap:anywhere}\n",
    ".banner{border-left:4px solid var(--bad);background:var(--panel);padding:.6rem 1rem;"
    "margin:1rem 0;color:var(--ink)}\n",
    ".cards{display:grid;grid-template-columns:repeat(auto-fit,minmax(12rem,1fr));gap:.8rem;"
    "margin-bottom:1.2rem}\n",
    ".card{background:var(--panel);border:1px solid var(--line);border-radius:8px;"
    "padding:.8rem 1rem}\n",
    ".card p{margin:0;color:var(--soft);font-size:.88rem}"
    ".card .label{font-weight:600;font-size:.8rem}\n",
    ".card .big{font-size:1.65rem;font-weight:650;line-height:1.3;color:var(--ink)}"
    ".card small{font-size:1rem}\n",
    ".card .good,.good{color:var(--good)}.card .bad,.bad{color:var(--bad)}.card .warn,.card "
    ".unsure{color:var(--warn)}\n",
    "table{border-collapse:collapse;width:100%;margin:.8rem 0;font-size:.92rem}\n",
    "caption{text-align:left;font-weight:600;padding-bottom:.3rem}\n",
    "th,td{text-align:left;padding:.3rem .6rem;border-bottom:1px solid var(--line);"
    "vertical-align:middle}\n",
    "th{font-weight:500}tr th:first-child,tr "
    "td:first-child{padding-left:0}td.n:first-child,th.n:first-child{width:2.2rem}thead "
    "th{font-weight:600;color:var(--soft);font-size:.82rem}\n",
    "tfoot th,tfoot td{font-weight:700;border-bottom:0}"
    ".n{text-align:right;white-space:nowrap}\n",
    "tr.group th{font-weight:700;padding-top:.9rem;border-bottom:2px solid var(--line)}\n",
    ".bands caption{font-weight:400;color:var(--soft)}.bands td.n{padding-right:.5rem}"
    ".bar{width:212px}.bar svg{display:block;width:200px}\n",
    ".note{color:var(--soft);font-size:.88rem;max-width:52rem}"
    ".absent{color:var(--soft);font-style:italic}\n",
    ".sources{font-size:.84rem;color:var(--soft);padding-left:1rem;columns:2;column-gap:2rem}"
    ".sources li{break-inside:avoid;list-style:none;text-indent:-1rem}\n",
    "em.unsure{color:var(--warn);font-size:.82rem;font-style:normal;white-space:nowrap}\n",
    "figure{margin:1rem 0}figcaption{font-weight:600;font-size:.92rem;margin-bottom:.2rem}\n",
    "figure svg{display:block;width:100%;height:auto}\n",
    ".pair{display:grid;grid-template-columns:repeat(auto-fit,minmax(20rem,1fr));gap:1.2rem;"
    "align-items:start}\n",
    ".pair div,.pair figure{min-width:0}.half svg{max-width:29rem}.mark svg{max-width:19rem}\n",
    ".pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(20rem,1fr));"
    "gap:1rem}\n",
    ".pictures figure{margin:0}"
    ".pictures img{width:100%;height:auto;border:1px solid var(--line);border-radius:6px;"
    "background:#fff}\n",
    ".pictures figcaption{font-weight:400;color:var(--soft);overflow-wrap:anywhere}\n",
    ".legend{font-size:.86rem;color:var(--soft);display:flex;flex-wrap:wrap;gap:.3rem 1.2rem;"
    "margin:.4rem 0}\n",
    ".legend span{display:inline-flex;align-items:center;gap:.35rem}\n",
    ".key::before{content:'';display:inline-block;width:22px;"
    "border-top:2.5px solid currentColor}\n",
    ".key.left{color:var(--left)}.key.right{color:var(--right)}"
    ".key.right::before,.key.widest::before{border-top-style:dashed}\n",
    ".key.cut{color:var(--soft)}"
    ".key.cut::before{width:0;height:14px;border-top:0;border-left:1.5px dashed var(--soft)}\n",
    ".key.gap{color:var(--good)}.key.widest{color:var(--warn)}\n",
    ".verdict strong{font-size:1.4rem;margin-right:.3rem}details{margin:.6rem 0}"
    "summary{cursor:pointer}\n",
    "dl{display:grid;grid-template-columns:max-content 1fr;gap:.2rem 1rem;font-size:.92rem}"
    "dt{color:var(--soft)}dd{margin:0;min-width:0}\n",
    "footer{padding-bottom:3rem}\n",
    "text{fill:var(--ink);font:12px system-ui,'Segoe UI',Roboto,Arial,sans-serif}\n",
    ".tick{fill:var(--soft);font-size:11.5px}.unit{fill:var(--soft);font-size:12px}"
    ".lane{fill:var(--soft)}\n",
    ".inphase{font-size:11.5px}.grid{stroke:var(--line);stroke-width:1}"
    ".cut{stroke:var(--soft);stroke-width:1;stroke-dasharray:3 4;opacity:.7}\n",
    "path.left,path.right,path.gap,path.widest{fill:none;stroke-width:1.4;"
    "stroke-linejoin:round}\n",
    "path.left{stroke:var(--left)}path.right{stroke:var(--right);stroke-dasharray:5 2.5}"
    "path.thin{stroke-width:.9;opacity:.85}\n",
    "path.thin.right{stroke-dasharray:none}\n",
    "path.gap{stroke:var(--good)}path.widest{stroke:var(--warn);stroke-dasharray:5 2.5}\n",
    ".phase.p0{fill:var(--p0)}.phase.p1{fill:var(--p1)}.phase.p2{fill:var(--p2)}"
    ".phase.p3{fill:var(--p3)}.phase.p4{fill:var(--p4)}.phase.p5{fill:var(--p5)}\n",
    ".hold.left{fill:var(--left)}.hold.right{fill:var(--right)}\n",
    ".m-needle{fill:var(--good)}.m-bad{fill:var(--bad);stroke:var(--bad)}"
    ".m-knot{fill:var(--knot)}td.back{color:var(--bad)}.m-cut{fill:var(--ink)}.m-tool{fill:var(--"
    "left)}.m-warn{fill:var(--warn)}\n",
    ".stroke{fill:none;stroke-width:2}.scale{stroke:var(--soft);stroke-width:1.2;fill:none}\n",
    ".band{fill:var(--band)}"
    ".band.unsure{fill:var(--band);opacity:.75;stroke:var(--good);stroke-dasharray:2.5 2}\n",
    ".typical{stroke:var(--good);stroke-width:2}"
    ".value{fill:var(--ink);stroke:var(--paper);stroke-width:1.5}\n",
    ".ring{fill:none;stroke:var(--line)}"
    ".ring.first{stroke:var(--good);fill:var(--band);fill-opacity:.35}\n",
    ".cross{stroke:var(--ink);stroke-width:1.5;fill:none}.hole{fill:var(--right)}"
    ".hole.back{fill:none;stroke:var(--bad);stroke-width:2}\n",
    "@media (max-width:46rem){.sources{columns:1}.bar{display:none}}\n",
    "@media print{:root{--paper:#fff;--ink:#000;--soft:#444;--line:#bbb;--panel:#fff;"
    "--left:#1b6ec2;--right:#c4570a;--good:#177245;\n",
    "--warn:#9a5b00;--bad:#b3261e;--band:#bfe0cc;--p0:#d6e4f5;--p1:#e4dcf3;--p2:#d8ecdf;"
    "--p3:#f6e6cf;--p4:#f3d9de;--p5:#d9ecef}\n",
    "body{font-size:10.5pt;-webkit-print-color-adjust:exact;print-color-adjust:exact}"
    "main,header,footer{max-width:none;padding:0}\n",
    "figure,table.bands "
    "tr,.card{break-inside:avoid}h2,tr.group{break-after:avoid}.cards{grid-template-columns:repeat("
    "4,1fr)}"
    "a{color:inherit;text-decoration:none}}\n",
    NULL};

// Draws charts from data, in the colours of the page and again when these change. Chart.js is in the page already.

/** The data that the page brings with it. */
function pageData() {
  return JSON.parse(document.getElementById('report').textContent);
}

/**
 * Draws data.charts, each {id, x, y, yType, xType, sets, marks, limits, f}. A set is {name, group, points: [{x, y}]} or, on
 * the chart's common abscissae f, {name, group, y: []}; dash, dots, width, fill (as in Chart.js) and quiet (not in the
 * legend) are optional. `group` is a colour of the page. data.named are the vertical lines of charts with marks. Returns
 * show(chart), which draws a chart in the place of the one with the same id.
 */
function pageCharts(data) {
  const dashes = [[], [7, 4], [2, 3], [10, 3, 2, 3], [4, 2], [1, 2]];
  const drawn = new Map();
  const wanted = new Map(data.charts.map((chart) => [chart.id, chart]));
  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();

  // Vertical lines at frequencies that have a name, labelled where there is room.
  const marks = {
    id: 'marks',
    afterDatasetsDraw(chart) {
      const { ctx, chartArea, scales } = chart;
      ctx.save();
      ctx.font = '11px system-ui, sans-serif';
      let lastX = -Infinity;
      for (const mark of [...(data.named || [])].sort((a, b) => a.f - b.f)) {
        const x = scales.x.getPixelForValue(mark.f);
        if (!(x > chartArea.left && x < chartArea.right)) continue;
        ctx.strokeStyle = colour('mark');
        ctx.setLineDash([4, 4]);
        ctx.beginPath();
        ctx.moveTo(x, chartArea.top);
        ctx.lineTo(x, chartArea.bottom);
        ctx.stroke();
        if (x - lastX < 16) continue;
        lastX = x;
        ctx.fillStyle = colour('mark');
        ctx.save();
        ctx.translate(x + 10, chartArea.top + 4);
        ctx.rotate(Math.PI / 2);
        ctx.strokeStyle = colour('panel'); // a halo, so that the curve behind does not cross the letters
        ctx.setLineDash([]);
        ctx.lineWidth = 4;
        ctx.strokeText(mark.name, 0, 6);
        ctx.fillText(mark.name, 0, 6);
        ctx.restore();
      }
      ctx.restore();
    }
  };

  // Ticks of a logarithmic axis: 1, 2, 5 of every decade, or whole decades where there are more than three.
  function buildTicks(axis) {
    if (axis.type !== 'logarithmic') return;
    const low = Math.floor(Math.log10(axis.min)), high = Math.ceil(Math.log10(axis.max));
    const steps = axis.axis === 'y' && Math.log10(axis.max / axis.min) > 3 ? [1] : [1, 2, 5];
    axis.ticks = [];
    for (let decade = low; decade <= high; ++decade)
      for (const step of steps) {
        const value = Number((step * Math.pow(10, decade)).toPrecision(1));
        if (value >= axis.min && value <= axis.max) axis.ticks.push({ value });
      }
  }

  // 1e-7 rather than 0.0000001.
  function tick(value) {
    return value !== 0 && (Math.abs(value) < 1e-3 || Math.abs(value) >= 1e5) ? value.toExponential(0) : String(Math.round(value * 1e6) / 1e6);
  }

  function axes(chart) {
    const base = (title) => ({ title: { display: true, text: title, color: colour('ink') }, ticks: { color: colour('soft'), maxRotation: 0, autoSkip: true, callback: tick }, grid: { color: colour('rule') }, afterBuildTicks: buildTicks });
    return {
      x: Object.assign(base(chart.x), { type: chart.xType || 'logarithmic' }),
      y: Object.assign(base(chart.y), { type: chart.yType })
    };
  }

  function dataset(set, dash) {
    return { label: set.name, data: set.points, borderColor: colour(set.group), backgroundColor: set.fill ? colour(set.group) + '33' : colour(set.group),
      borderDash: set.dash || dash, borderWidth: set.width ?? 1.4, pointRadius: set.dots || set.markers ? 3 : 0, showLine: !set.dots || set.dots === 'joined',
      fill: set.fill || false, spanGaps: false, quiet: set.quiet };
  }

  function draw(chart) {
    const canvas = document.getElementById(chart.id);
    if (!canvas) return;
    const counts = {};
    const sets = chart.sets.map((set) => set.points ? set : Object.assign({ points: chart.f.map((x, i) => ({ x, y: set.y[i] })) }, set));
    const datasets = sets.map((set) => dataset(set, dashes[(counts[set.group] = (counts[set.group] ?? -1) + 1) % dashes.length]));
    const abscissae = sets.flatMap((set) => set.points.map((point) => point.x));
    const scales = axes(chart), limits = chart.limits || {};
    Object.assign(scales.x, { min: Math.min(...abscissae), max: Math.max(...abscissae) }, limits.x || {});
    Object.assign(scales.y, limits.y || {});
    drawn.get(chart.id)?.destroy();
    drawn.set(chart.id, new Chart(canvas, {
      type: 'line', data: { datasets }, plugins: chart.marks ? [marks] : [],
      options: { animation: false, parsing: false, normalized: true, maintainAspectRatio: false, scales, interaction: { mode: 'nearest', axis: 'x', intersect: false },
        plugins: { legend: { labels: { color: colour('ink'), boxWidth: 26, boxHeight: 0, filter: (item, all) => !all.datasets[item.datasetIndex].quiet } },
          tooltip: { callbacks: { title: (items) => items.length ? items[0].parsed.x.toPrecision(4) + ' ' + (chart.xUnit || 'Hz') : '' } } } }
    }));
  }

  function show(chart) {
    wanted.set(chart.id, chart);
    draw(chart);
  }
  const drawAll = () => wanted.forEach(draw);
  drawAll();
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', drawAll);
  const paper = (on) => { document.documentElement.classList.toggle('paper', on); drawAll(); };
  window.addEventListener('beforeprint', () => paper(true));
  window.addEventListener('afterprint', () => paper(false));
  return show;
}

// Draws the charts of an inspection page from the data in #report. Chart.js is in the page already.
(function () {
  const data = JSON.parse(document.getElementById('report').textContent);
  const dashes = [[], [7, 4], [2, 3], [10, 3, 2, 3], [4, 2], [1, 2]];
  const charts = [];
  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();

  // Vertical lines at frequencies that have a name, labelled where there is room.
  const marks = {
    id: 'marks',
    afterDatasetsDraw(chart) {
      const { ctx, chartArea, scales } = chart;
      ctx.save();
      ctx.font = '11px system-ui, sans-serif';
      let lastX = -Infinity;
      for (const mark of [...data.named].sort((a, b) => a.f - b.f)) {
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

  function axes(xTitle, yTitle, yType, xType) {
    const base = (title) => ({ title: { display: true, text: title, color: colour('ink') }, ticks: { color: colour('soft'), maxRotation: 0, autoSkip: true, callback: tick }, grid: { color: colour('rule') }, afterBuildTicks: buildTicks });
    return {
      x: Object.assign(base(xTitle), { type: xType || 'logarithmic' }),
      y: Object.assign(base(yTitle), { type: yType })
    };
  }

  function draw(id, sets, scales, limits, withMarks, xUnit) {
    const canvas = document.getElementById(id);
    if (!canvas) return;
    const counts = {};
    const datasets = sets.map((set) => {
      const n = counts[set.group] = (counts[set.group] ?? -1) + 1;
      return { label: set.name, data: set.points, borderColor: colour(set.group), backgroundColor: colour(set.group), borderDash: set.dash || dashes[n % dashes.length],
        borderWidth: 1.4, pointRadius: set.dots || set.markers ? 3 : 0, showLine: !set.dots, spanGaps: false };
    });
    const lowest = Math.min(...sets.flatMap((set) => set.points.map((point) => point.x)));
    const highest = Math.max(...sets.flatMap((set) => set.points.map((point) => point.x)));
    Object.assign(scales.x, { min: lowest, max: highest }, limits.x || {});
    Object.assign(scales.y, limits.y || {});
    charts.push(new Chart(canvas, {
      type: 'line', data: { datasets }, plugins: withMarks ? [marks] : [],
      options: { animation: false, parsing: false, normalized: true, maintainAspectRatio: false, scales, interaction: { mode: 'nearest', axis: 'x', intersect: false },
        plugins: { legend: { labels: { color: colour('ink'), boxWidth: 26, boxHeight: 0 } }, tooltip: { callbacks: { title: (items) => items.length ? items[0].parsed.x.toPrecision(4) + ' ' + (xUnit || 'Hz') : '' } } } }
    }));
  }

  function drawAll() {
    charts.splice(0).forEach((chart) => chart.destroy());
    for (const chart of data.charts) draw(chart.id, chart.sets, axes(chart.x, chart.y, chart.yType, chart.xType), chart.limits || {}, chart.marks, chart.xUnit);
  }
  drawAll();
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', drawAll);
})();

// Fills the report of a diagnosis: the worst channel, and the channel that the selector names.
(function () {
  const data = pageData();
  const band = (id, channel) => ({ id, x: 'third octave, Hz', y: 'recording over model, dB', yType: 'linear', f: channel.centres, sets: channel.bands });
  const spectrum = (id, channel) => ({ id, x: 'frequency, Hz', y: channel.quantity, yType: 'logarithmic', f: channel.f, sets: channel.sets });
  const charts = (which, channel) => [spectrum(which + '_spectrum', channel), band(which + '_bands', channel)]
    .filter((chart) => chart.sets.length && chart.f.length);
  if (data.channels.length) {
    data.charts.push(...charts('worst', data.channels[data.worst]));
    data.charts.push(...charts('chosen', data.channels[0]));
  }
  const show = pageCharts(data);
  document.getElementById('channel')?.addEventListener('change', (event) => charts('chosen', data.channels[event.target.value]).forEach(show));
})();

# Pages are built by npm and esbuild at configure time and embedded; see src/report.

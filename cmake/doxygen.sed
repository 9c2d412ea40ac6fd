# Links of the pages as Doxygen 1.9 resolves them: to pages without a heading, to pictures by their names; other
# files of the repository are not in the reference.
s/\]\(([^):]*\.md)#[^)]*\)/](\1)/g
s/\]\(([^):]*\/)([a-z_]+\.(png|gif))\)/](\2)/g
s/(^|[^!])\[([^]]*)\]\([^):]*(\.cpp|\.h|LICENSE)\)/\1`\2`/g

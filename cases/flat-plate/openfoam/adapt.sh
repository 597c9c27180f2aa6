# The floor before the plate has layers, but is no wall to the flow.
foamDictionary constant/polyMesh/boundary -entry entry0.upstream.type -set patch > /dev/null

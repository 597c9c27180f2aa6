# Separated flow over corners starts roughly: bounded gradients, first-order turbulence, a pressure that is solved more exactly.
set_entry() { foamDictionary "system/$1" -entry "$2" -set "$3" > /dev/null; }
set_entry fvSchemes "gradSchemes.limited" "cellLimited Gauss linear 1"
set_entry fvSchemes "divSchemes.div(phi,U)" "bounded Gauss linearUpwind limited"
set_entry fvSchemes "divSchemes.div(phi,k)" "bounded Gauss upwind"
set_entry fvSchemes "divSchemes.div(phi,omega)" "bounded Gauss upwind"
set_entry fvSolution "solvers.p.relTol" 0.01
set_entry fvSolution "SIMPLE.nNonOrthogonalCorrectors" 1
set_entry fvSolution "relaxationFactors.equations.U" 0.7
set_entry fvSolution 'relaxationFactors.equations."(k|omega)"' 0.6

# The far field is near for a section that lifts: it gets the velocity that the section's circulation leaves there.
postProcess -func writeCellCentres -time 0 > log.centres
/usr/bin/python3 vortex.py

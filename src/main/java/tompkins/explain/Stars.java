package tompkins.explain;

import java.util.List;
import java.util.Locale;
import tompkins.light.ColourLaw;
import tompkins.light.StarCatalogue;
import tompkins.property.NumberText;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;

/** Says in sentences what a picture shows of stars, and what it leaves out. */
final class Stars {

    private Stars() {}

    /** The sentences; none if there are no stars. */
    static List<String> sentences(Studio studio) {
        if (!(studio.background() instanceof StarSky sky)) {
            return List.of();
        }
        String stars = String.format(
                Locale.ROOT,
                "The sky holds %d stars, to magnitude %s at rest; each is a spot of a few pixels with all its light,"
                        + " whatever the size of the picture and the number of samples. ",
                StarCatalogue.upTo(sky.limit()).size(),
                NumberText.of(sky.limit()));
        if (!studio.shiftsColours()) {
            return List.of(stars + "Motion moves them and leaves them as bright as they are.");
        }
        return List.of(
                stars
                        + (studio.colours() == ColourLaw.SEARCHLIGHT
                                ? "A star gets brighter with the square of the Doppler factor D."
                                : "A star is seen as a black body of D times its temperature."),
                "Stars that are fainter at rest are left out, although the motion would make many of them visible ahead;"
                        + " the catalogue ends at magnitude " + NumberText.of(StarCatalogue.FAINTEST) + ".");
    }
}

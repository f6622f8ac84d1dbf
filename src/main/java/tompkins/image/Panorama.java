package tompkins.image;

import java.util.Locale;

/**
 * How much of the sphere around the camera a picture shows, whose columns are even steps of longitude and whose rows
 * are even steps of latitude, with the horizon in the middle.
 *
 * @param longitudes from the left edge to the right, above 0 to 360 degrees
 * @param latitudes from the upper edge to the lower, above 0 to 180 degrees
 */
public record Panorama(double longitudes, double latitudes) {

    /** Where viewers of panoramas look for such a text in a PNG file. */
    static final String KEYWORD = "XML:com.adobe.xmp";

    /**
     * The text in XMP for a picture of a size, by which viewers show it on a sphere (Photo Sphere XMP Metadata,
     * https://developers.google.com/streetview/spherical-metadata).
     */
    String xmp(int width, int height) {
        long fullWidth = Math.round(width * 360 / longitudes);
        long fullHeight = Math.round(height * 180 / latitudes);
        return String.format(
                Locale.ROOT,
                """
                <?xpacket begin="\ufeff" id="W5M0MpCehiHzreSzNTczkc9d"?>
                <x:xmpmeta xmlns:x="adobe:ns:meta/">
                <rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">
                <rdf:Description rdf:about="" xmlns:GPano="http://ns.google.com/photos/1.0/panorama/"
                 GPano:UsePanoramaViewer="True" GPano:ProjectionType="equirectangular"
                 GPano:FullPanoWidthPixels="%d" GPano:FullPanoHeightPixels="%d"
                 GPano:CroppedAreaImageWidthPixels="%d" GPano:CroppedAreaImageHeightPixels="%d"
                 GPano:CroppedAreaLeftPixels="%d" GPano:CroppedAreaTopPixels="%d"/>
                </rdf:RDF>
                </x:xmpmeta>
                <?xpacket end="w"?>""",
                fullWidth,
                fullHeight,
                width,
                height,
                (fullWidth - width) / 2,
                (fullHeight - height) / 2);
    }
}

package tompkins.io;

import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/** Finds the word that may have been meant. */
public final class Spelling {

    private static final int LONGEST = 60;

    /** Shorter words are parts of too many others. */
    private static final int SHORTEST_PART = 4;

    /** What other programs, and people, call what has another name here. */
    private static final Map<String, Set<String>> OTHER_NAMES = Map.ofEntries(
            Map.entry("Box", Set.of("cube", "cuboid", "block", "boxgeometry")),
            Map.entry("Sphere", Set.of("ball", "icosphere")),
            Map.entry("Disc", Set.of("circle")),
            Map.entry("Cylinder", Set.of("rod", "tube", "pipe", "cylindergeometry")),
            Map.entry("Parallelogram", Set.of("square", "rectangle", "quad")),
            Map.entry("Plane", Set.of("floor", "ground")),
            Map.entry("ThinLensCamera", Set.of("pinhole", "pinholecamera", "perspective", "perspectivecamera")),
            Map.entry("PanoramicCamera", Set.of("panorama", "equirectangular", "spherical")),
            Map.entry(
                    "PointLight",
                    Set.of("lamp", "sun", "bulb", "lightsource", "directionallight", "arealight", "spotlight")),
            Map.entry("SkyBackground", Set.of("sky")),
            Map.entry("Refractive", Set.of("glass", "water", "dielectric", "transparent")),
            Map.entry("Mirror", Set.of("reflective", "metal", "chrome", "conductor", "mirrorlike")),
            Map.entry("Tiling", Set.of("checkerboard", "chequerboard", "chessboard", "checker")),
            Map.entry("PictureSurface", Set.of("texture", "image", "imagetexture")),
            Map.entry(
                    "ColouredSurface",
                    Set.of(
                            "matte",
                            "diffuse",
                            "lambertian",
                            "phong",
                            "color",
                            "colour",
                            "lambert",
                            "meshstandardmaterial",
                            "meshphongmaterial",
                            "plastic")),
            Map.entry(
                    "LuminousSurface",
                    Set.of("emissive", "glowing", "emission", "meshbasicmaterial", "emitter", "unlit")),
            Map.entry("scene", Set.of("objects")),
            Map.entry("lights", Set.of("lamps")),
            Map.entry("title", Set.of("name")),
            Map.entry("description", Set.of("name")),
            Map.entry("mesh", Set.of("file")),
            Map.entry("surface", Set.of("material", "color", "colour", "texture", "pigment")),
            Map.entry("diffuse", Set.of("color", "colour")),
            Map.entry("velocity", Set.of("speed")),
            Map.entry("centre", Set.of("position", "location", "middle")),
            Map.entry("position", Set.of("location", "place")),
            Map.entry("viewDirection", Set.of("direction", "lookat", "target")),
            Map.entry("topDirection", Set.of("up", "updirection")),
            Map.entry("place", Set.of("position", "location", "centre", "center", "origin", "point")),
            Map.entry("beta", Set.of("speed", "v")),
            Map.entry("anaglyph", Set.of("redcyan", "cyanred")),
            Map.entry("side-by-side", Set.of("sbs")),
            Map.entry("top-and-bottom", Set.of("overunder", "topbottom")),
            Map.entry("Group", Set.of("union", "merge", "collection")),
            Map.entry("AmbientLight", Set.of("ambient", "hemispherelight", "environment")),
            Map.entry("UniformBackground", Set.of("solid", "color", "colour")),
            Map.entry("PanoramaBackground", Set.of("environment", "envmap", "hdri", "skybox")),
            Map.entry("TriangleMesh", Set.of("model", "trimesh", "objmesh")),
            Map.entry("from", Set.of("min", "minimum")),
            Map.entry("to", Set.of("max", "maximum")),
            Map.entry("start", Set.of("base", "basepoint")),
            Map.entry("end", Set.of("tip", "cappoint")),
            Map.entry("rotationDegrees", Set.of("rotation", "rotate", "angle")),
            Map.entry("translation", Set.of("translate", "offset")),
            Map.entry("apertureRadius", Set.of("fstop", "fnumber", "lensradius")),
            Map.entry("focusDistance", Set.of("focaldistance")),
            Map.entry("exposureTime", Set.of("shutterspeed", "shuttertime")),
            Map.entry("openingTime", Set.of("time")),
            Map.entry("samples", Set.of("spp", "samplesperpixel", "antialiasing")),
            Map.entry("targetError", Set.of("error", "noise")),
            Map.entry("maximumDepth", Set.of("bounces", "recursion", "maxtracelevel")),
            Map.entry("colour", Set.of("intensity", "power", "brightness", "rgb")),
            Map.entry("indexRatio", Set.of("ior", "refractiveindex", "index", "eta")),
            Map.entry("reflectance", Set.of("reflectivity", "reflection")),
            Map.entry("picture", Set.of("file", "map", "filename")),
            Map.entry("horizontalAngleDegrees", Set.of("fov", "fieldofview", "angleofview")));

    private Spelling() {}

    /**
     * The end of a message, {@code ; did you mean "..."?} with the known word that means the same elsewhere, or else
     * the most similar one; empty if there is none.
     */
    public static String hint(String word, Collection<String> known) {
        if (word.length() > LONGEST) {
            return "";
        }
        String best = null;
        int fewest = Integer.MAX_VALUE;
        for (String candidate : known) {
            int changes = changes(plain(word), plain(candidate));
            // a word that would have to change all its letters is not similar
            boolean like = changes <= Math.max(1, candidate.length() / 3)
                    && changes < plain(candidate).length();
            if (like && changes < fewest) {
                best = candidate;
                fewest = changes;
            }
        }
        Optional<String> similar = Optional.ofNullable(best);
        return only(known, candidate -> isOtherName(word, candidate))
                .or(() -> similar)
                .or(() -> only(known, candidate -> isPart(word, candidate)))
                .or(() -> only(known, candidate -> beginsLike(word, candidate)))
                .map(meant -> "; did you mean \"" + meant + "\"?")
                .orElse("");
    }

    /** The known word that is like a word in some way, if there is exactly one. */
    private static Optional<String> only(Collection<String> known, Predicate<String> isLike) {
        List<String> like = known.stream().filter(isLike).toList();
        return like.size() == 1 ? Optional.of(like.get(0)) : Optional.empty();
    }

    private static boolean isOtherName(String word, String candidate) {
        return OTHER_NAMES.getOrDefault(candidate, Set.of()).contains(plain(word));
    }

    private static boolean isPart(String part, String candidate) {
        return plain(part).length() >= SHORTEST_PART && plain(candidate).contains(plain(part));
    }

    /** Whether the first of several words written together is the same, as in angularVelocity and angularSpeed. */
    private static boolean beginsLike(String word, String candidate) {
        String first = word.split("(?=\\p{Lu})|[-_ ]", 2)[0];
        return first.length() >= SHORTEST_PART && first.length() < word.length() && candidate.startsWith(first);
    }

    private static String plain(String word) {
        return word.toLowerCase(Locale.ROOT).replaceAll("[-_ ]", "");
    }

    /** Letters to insert, delete, replace or swap with their neighbours (distance of Damerau and Levenshtein). */
    static int changes(String from, String to) {
        int[][] distance = new int[from.length() + 1][to.length() + 1];
        for (int i = 0; i <= from.length(); i++) {
            for (int j = 0; j <= to.length(); j++) {
                distance[i][j] = i == 0 || j == 0 ? i + j : step(distance, from, to, i, j);
            }
        }
        return distance[from.length()][to.length()];
    }

    private static int step(int[][] distance, String from, String to, int i, int j) {
        char a = from.charAt(i - 1);
        char b = to.charAt(j - 1);
        int replaced = distance[i - 1][j - 1] + (a == b ? 0 : 1);
        int least = Math.min(replaced, 1 + Math.min(distance[i - 1][j], distance[i][j - 1]));
        boolean swapped = i > 1 && j > 1 && a == to.charAt(j - 2) && b == from.charAt(i - 2);
        return swapped ? Math.min(least, distance[i - 2][j - 2] + 1) : least;
    }
}

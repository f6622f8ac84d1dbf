package tompkins.io;

/**
 * Another value for a key of a scene.
 *
 * @param option what the user calls it, such as {@code --set}; messages begin with it
 * @param path the way to the key, such as {@code settings.width}, {@code scene[0].radius} or {@code velocity.gamma}
 * @param value as in a scene file; a bare word is a text, numbers with commas between them are a list, and {@code 0,5}
 *     is 0.5 where one number belongs
 */
public record Assignment(String option, String path, String value) {}
